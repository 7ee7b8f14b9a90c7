## text = gsmbp__worst (names, scaled, found, limit)
## The rows of gsmbp__residuals above LIMIT (or the largest, if none is), the worst
## first, six at most: "C.x = 0.012, rate of C.x = 0.3".

function text = gsmbp__worst (names, scaled, found, limit)
  if (isempty (names))
    text = "no row that could be looked at";
    return;
  endif
  size_ = abs (scaled);
  size_(isnan (size_)) = Inf;
  [size_, order] = sort (size_, "descend");
  n = max (1, sum (size_ > limit));
  shown = order(1:min (n, 6))';
  one = @(k) sprintf ("%s = %.6g", names{k}, found(k));
  text = strjoin (arrayfun (one, shown, "UniformOutput", false), ", ");
  if (n > 6)
    text = sprintf ("%s and %d more", text, n - 6);
  endif
  text = [text, gsmbp__nowhere(found(shown))];
endfunction
