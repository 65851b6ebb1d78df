# Completion of `eyebridge` for fish. What can come next, the command itself knows.
function __eyebridge_words
    set -l before (commandline -opc)
    set -l current (commandline -ct)
    for found in ($before[1] completion words -- $before[2..-1] "$current" 2>/dev/null)
        switch $found
            case "*"\t"*"
                echo $found
            case files folders
                set -l option (string match -r '^--[^=]*=' -- "$current")
                set -l written (string replace -r '^--[^=]*=' '' -- "$current")
                if test $found = folders
                    printf '%s\n' "$option"(__fish_complete_directories "$written")
                else
                    printf '%s\n' "$option"(__fish_complete_path "$written")
                end
        end
    end
end
complete -c eyebridge -f -a '(__eyebridge_words)'
