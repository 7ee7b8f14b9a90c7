## j = speed_job (who, mode, word, library, start, symbol, outputs): one job of driver.c; without
## arguments none.

function j = speed_job (varargin)
  if (nargin == 0)
    varargin = repmat ({{}}, 1, 7);
  end
  j = struct ("who", varargin{1}, "mode", varargin{2}, "word", varargin{3}, "library", ...
              varargin{4}, "start", varargin{5}, "symbol", varargin{6}, "outputs", varargin{7});
end
