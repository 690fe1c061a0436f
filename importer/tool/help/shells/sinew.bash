# bash completion of sinew, which names the candidates itself
_sinew() {
  local IFS=$'\n'
  COMPREPLY=($(sinew --complete "${COMP_WORDS[@]:1:COMP_CWORD}" 2> /dev/null | cut -f 1))
}
complete -o default -F _sinew sinew
