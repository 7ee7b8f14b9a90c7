## C = pose_centres (T, BODY): mass centres of bodies at the placements T, a column each.

function c = pose_centres (T, body)
  c = zeros (3, numel (body));
  for k = 1:numel (body)
    c(:, k) = T(1:3, :, k) * [body(k).centre; 1];
  end
end
