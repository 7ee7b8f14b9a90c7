## list = gs.drive.given_parts (who, kind, list)
## A row of parts of that KIND, the typical ones where LIST is empty; an error of WHO about the
## option KIND where it is no list of gsmbp_catalogue.

function list = given_parts (who, kind, list)
  if (isempty (list))
    list = gsmbp_catalogue (kind);
  endif
  known = gs.drive.catalogue_fields (kind);
  fields = [{"name"}; known(:,1)];
  if (! isstruct (list))
    error ("%s: option %s: expected a list of gsmbp_catalogue (\"%s\"), found %s", who, kind, ...
           kind, gs.text.shown_value (list));
  elseif (! all (isfield (list, fields)))
    error (["%s: option %s: expected a list of gsmbp_catalogue (\"%s\") with the fields %s, " ...
            "found %s"], who, kind, kind, strjoin (fields', ", "), ...
           strjoin (fieldnames (list)', ", "));
  endif
  list = list(:)';
endfunction
