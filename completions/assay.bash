# SPDX-License-Identifier: BSD-3-Clause
# bash completion for assay, which itself says what may follow (drivers/command_line/completion.hpp)
_assay() {
  local offer last=${COMP_WORDS[COMP_CWORD]}
  COMPREPLY=()
  while IFS=$'\t' read -r offer _; do
    case $offer in
      '*/') mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -d -- "$last") ;;
      '*'*) mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -f -X "!$offer" -- "$last") ;;
      "$last"*) COMPREPLY+=("$offer") ;;
    esac
    [[ $offer != '*'* ]] || compopt -o filenames
  done < <("${COMP_WORDS[0]/#\~/$HOME}" --complete "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null)
}
complete -F _assay assay
