## v = inputs_of (m, name, value, ...)
## The column of inputs of a model: those named have these values, the others are 0.

function v = inputs_of (m, varargin)
  v = zeros (numel (m.inputs), 1);
  for k = 1:2:numel (varargin)
    v(strcmp (m.inputs, varargin{k})) = varargin{k+1};
  end
end
