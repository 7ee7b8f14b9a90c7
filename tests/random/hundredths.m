## text = hundredths (X): the number as an exact fraction of hundredths, for a scene.

function text = hundredths (x)
  text = sprintf ("%d/100", round (100 * x));
end
