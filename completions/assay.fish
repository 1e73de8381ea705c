# SPDX-License-Identifier: BSD-3-Clause
# fish completion for assay, which itself says what may follow (drivers/command_line/completion.hpp)
function __assay_offers
    set -l words (commandline -opc)
    set -l last (commandline -ct)
    set -l program $words[1]
    set -e words[1]
    set -l offers ($program --complete $words "$last" 2>/dev/null)
    string match -v -- '\**' $offers
    if string match -q -r -- '^\*(?!/$)' $offers
        __fish_complete_path "$last"
    else if contains -- '*/' $offers
        __fish_complete_directories "$last" ''
    end
end
complete -c assay -f -a '(__assay_offers)'
