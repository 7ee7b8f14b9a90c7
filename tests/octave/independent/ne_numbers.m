## x = ne_numbers (TEXT): the number(s) of a decimal or exact string such as "0.1", "1/12",
## "(0.8)*(0.7)**2/12", or of nested lists of them: a list is a column, a list of lists a matrix
## with a row for each.

function x = ne_numbers (text)
  if (isnumeric (text))
    x = double (text);
  elseif (iscell (text))
    parts = cellfun (@ne_numbers, text(:), "UniformOutput", false);
    if (all (cellfun (@isscalar, parts)))
      x = vertcat (parts{:});
    else
      x = horzcat (parts{:})';
    end
  elseif (strcmp (text, "nan"))
    x = NaN;
  elseif (isempty (regexp (regexprep (text, 'pi|sqrt', ''), '[^-+*/^().0-9eE ]', "once")))
    x = eval (strrep (text, "**", "^"));
  else
    error ("ne_numbers: not a number: %s", text);
  end
end
