## text = gs.text.derivative_name (k)
## How the K-th derivative of a reference ends: _ref, _d_ref, _dd_ref.

function text = derivative_name (k)
  text = "_ref";
  if (k > 0)
    text = ["_" repmat("d", 1, k) "_ref"];
  endif
endfunction
