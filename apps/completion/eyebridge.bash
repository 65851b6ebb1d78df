# Completion of `eyebridge` for bash. What can come next, the command itself knows.
_eyebridge() {
  # bash has split the words at = and : as well; those without a space between belong together.
  local line=${COMP_LINE:0:COMP_POINT} words=() word index
  for ((index = 0; index <= COMP_CWORD; ++index)); do
    word=${COMP_WORDS[index]}
    if [[ $line == [[:space:]]* || $index = 0 ]]; then
      line=${line#"${line%%[![:space:]]*}"}
      words+=("$word")
    else
      words[-1]+=$word
    fi
    line=${line#"$word"}
  done
  local current=${words[-1]} found lines
  mapfile -t lines < <("${words[0]/#\~/$HOME}" completion words -- "${words[@]:1}" 2>/dev/null)
  COMPREPLY=()
  for found in "${lines[@]}"; do
    case $found in
      *$'\t'*) COMPREPLY+=("${found%%$'\t'*}") ;;
      more) compopt -o nospace ;;
      files | folders)
        compopt -o filenames
        local kind=-f
        [ "$found" = files ] || kind=-d
        mapfile -t -O ${#COMPREPLY[@]} COMPREPLY < <(compgen $kind -- "${current#*=}")
        ;;
    esac
  done
  # bash replaces only what is behind the last = or : of the word.
  local kept=${current%"${current##*[=:]}"}
  for index in "${!COMPREPLY[@]}"; do COMPREPLY[index]=${COMPREPLY[index]#"$kept"}; done
}
complete -F _eyebridge eyebridge
