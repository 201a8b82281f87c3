# Completion of commands, options and file names in bash; the program itself says what there is.
_vibro_impact() {
  local words
  if ((COMP_CWORD == 1)); then
    words="--help --version $("$1" --help 2>/dev/null |
      sed -nE '/^Subcommands:/,/^$/s/^  ([a-z]+) .*/\1/p')"
  elif [[ ${COMP_WORDS[COMP_CWORD]} == -* ]]; then
    words=$("$1" "${COMP_WORDS[1]}" --help 2>/dev/null |
      sed -nE 's/^  (-[a-z],)?(--[a-z-]+).*/\2/p')
  fi
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "${COMP_WORDS[COMP_CWORD]}")
}
complete -o default -F _vibro_impact vibro-impact
