## places = gs.model.free_inputs (m)
## The places of the inputs of the scene M that no sampled device holds and that are no modes.

function places = free_inputs (m)
  places = 1:m.sizes.nv;
  taken = [vertcat(m.controllers.outputs); vertcat(m.events.input)];
  places(taken(taken > 0)) = [];
endfunction
