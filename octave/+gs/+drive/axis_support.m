## support = gs.drive.axis_support (s, name)
## The support {length, ends} that the specification S gives the screw of the coordinate NAME; {}
## where it gives none.

function support = axis_support (s, name)
  support = vertcat (s.support{strcmp (s.support(:,1), name),2});
  if (isempty (support))
    support = {};
  endif
endfunction
