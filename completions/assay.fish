# SPDX-License-Identifier: BSD-3-Clause
set -l verbs run tabulate eval explain materials register schema
complete -c assay -f
complete -c assay -n "not __fish_seen_subcommand_from $verbs" -a run -d 'The full simulation'
complete -c assay -n "not __fish_seen_subcommand_from $verbs" -a tabulate -d 'Sheet and curves of the point driver'
complete -c assay -n "not __fish_seen_subcommand_from $verbs" -a eval -d 'Exact fields at reference points'
complete -c assay -n "not __fish_seen_subcommand_from $verbs" -a explain -d 'Passes, columns, bytes and steps'
complete -c assay -n "not __fish_seen_subcommand_from $verbs" -a materials -d 'What is registered'
complete -c assay -n "not __fish_seen_subcommand_from $verbs" -a register -d 'Add a shared library or a description'
complete -c assay -n "not __fish_seen_subcommand_from $verbs" -a schema -d 'JSON Schema of scenes'
complete -c assay -n "__fish_seen_subcommand_from run tabulate eval explain materials register" -F
complete -c assay -n "__fish_seen_subcommand_from run tabulate eval explain" -l set -x -d 'key.path=value'
complete -c assay -n "__fish_seen_subcommand_from run tabulate eval" -s o -r -F -d 'Where results go'
complete -c assay -n "__fish_seen_subcommand_from run" -l threads -x -d 'Number of threads'
complete -c assay -n "__fish_seen_subcommand_from tabulate eval" -l points -r -F -d 'Table of points'
complete -c assay -n "__fish_seen_subcommand_from run tabulate explain materials" -l json -d 'JSON on standard output'
complete -c assay -n "__fish_seen_subcommand_from register" -l as -x -d 'Name'
complete -c assay -n "__fish_seen_subcommand_from register" -l remove -x -d 'Take a name out'
complete -c assay -s v -l verbose -d 'Say more'
complete -c assay -l quiet -d 'No progress'
complete -c assay -l version -d 'Version'
complete -c assay -s h -l help -d 'Help'
