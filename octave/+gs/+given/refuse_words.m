## gs.given.refuse_words (who, name, value, ...)
## An error of WHO where the VALUE of an argument NAME is a text: the name of an option that stands
## where an argument was left out.

function refuse_words (who, varargin)
  for k = 2:2:numel (varargin)
    if (ischar (varargin{k}))
      names = strjoin (varargin(1:2:end), ", ");
      error (["%s: argument %s: expected no text, found %s; options follow the arguments (%s): " ...
              "write [] for one that has a default"], who, varargin{k-1}, ...
             gs.text.shown_value (varargin{k}), names);
    endif
  endfor
endfunction
