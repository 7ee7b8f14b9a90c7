## text = peers_shell (command): what it prints; an error where it fails

function text = peers_shell (command)
  [status, text] = system ([command " 2>&1"]);
  if (status != 0)
    error ("bench-peers: %s\n%s", command, text);
  end
end
