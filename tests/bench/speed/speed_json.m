## text = speed_json (results): all numbers, without the places of files.

function text = speed_json (results)
  for k = 1:numel (results)
    for name = fieldnames (results)'
      if (isempty (results(k).(name{1})))
        ## jsonencode (Octave 7) stumbles over a struct array without elements
        results(k).(name{1}) = [];
      end
    end
  end
  text = jsonencode (rmfield (results, {"folder", "model"}));
end
