# fish completion of sinew, which names the candidates itself
function __sinew_complete
    set -l found (sinew --complete (commandline -opc)[2..] (commandline -ct) 2> /dev/null)
    count $found > /dev/null && printf '%s\n' $found || __fish_complete_path (commandline -ct)
end
complete -c sinew -f -a '(__sinew_complete)'
