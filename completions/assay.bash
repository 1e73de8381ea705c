# SPDX-License-Identifier: BSD-3-Clause
# bash completion for assay
_assay() {
  local cur=${COMP_WORDS[COMP_CWORD]} prev=${COMP_WORDS[COMP_CWORD - 1]} verb= word
  local verbs='run tabulate eval explain study recommend compare check materials register new-material schema'
  COMPREPLY=()
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    if [[ " $verbs " == *" $word "* ]]; then
      verb=$word
      break
    fi
  done
  if [[ -z $verb ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$verbs --help --version --verbose --quiet" -- "$cur")
    return
  fi
  case $prev in
    -o | --junit | --markdown | --from)
      mapfile -t COMPREPLY < <(compgen -f -- "$cur")
      compopt -o filenames
      return
      ;;
    --points)
      mapfile -t COMPREPLY < <(compgen -f -X '!*.csv' -- "$cur"; compgen -d -- "$cur")
      compopt -o filenames
      return
      ;;
    --deck)
      mapfile -t COMPREPLY < <(compgen -f -X '!*.inp' -- "$cur"; compgen -d -- "$cur")
      compopt -o filenames
      return
      ;;
    --set | --as | --remove | --parameters | --error | --shard | --props | --statev | --material | --symbol | --link | --junit-name) return ;;
    --threads | --jobs)
      mapfile -t COMPREPLY < <(compgen -W "1 2 4 8 16" -- "$cur")
      return
      ;;
    --language)
      mapfile -t COMPREPLY < <(compgen -W "c c++ fortran" -- "$cur")
      return
      ;;
    --interface)
      mapfile -t COMPREPLY < <(compgen -W "native umat" -- "$cur")
      return
      ;;
  esac
  local options='--help --quiet --verbose'
  case $verb in
    run) options+=' -o --set --threads --json --junit --junit-name' ;;
    tabulate) options+=' -o --set --points --json' ;;
    eval) options+=' -o --set --points' ;;
    explain) options+=' --set --json' ;;
    study) options+=' -o --jobs --resume --shard --merge --from --list --json' ;;
    recommend) options+=' --error -o --json' ;;
    compare) options+=' --json --markdown' ;;
    check) options+=' --parameters --json --junit --junit-name --quick --strain --pressure --step --methods --markdown --all --replay --explain'
      options+=' --props --statev --deck --material --symbol --link -o'
      ;;
    materials) options+=' --json --names' ;;
    register) options+=' --as --remove --props --statev --deck --material --symbol --link' ;;
    new-material) options+=' --language --interface -o' ;;
    schema) options+=' --study' ;;
  esac
  if [[ $cur == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$options" -- "$cur")
    return
  fi
  compopt -o filenames
  case $verb in
    run | tabulate | eval | explain | study)
      mapfile -t COMPREPLY < <(compgen -f -X '!*.y*ml' -- "$cur"; compgen -d -- "$cur")
      ;;
    recommend | compare)
      mapfile -t COMPREPLY < <(compgen -f -X '!*.@(json|yaml|yml)' -- "$cur"; compgen -d -- "$cur")
      ;;
    materials | check)
      mapfile -t COMPREPLY < <(compgen -W "$(assay materials --names 2>/dev/null)" -- "$cur"
        compgen -f -X '!*.@(so|yaml|yml|f|for|f90|f95|F|FOR|F90|inp)' -- "$cur"; compgen -d -- "$cur")
      ;;
    register)
      mapfile -t COMPREPLY < <(compgen -f -X '!*.@(so|yaml|yml|f|for|f90|f95|F|FOR|F90|inp)' -- "$cur"; compgen -d -- "$cur")
      ;;
  esac
}
complete -F _assay assay
