## -*- texinfo -*-
## @deftypefn  {} {@var{r} =} gsmbp_mobility (@var{m}, @var{x})
## @deftypefnx {} {@var{r} =} gsmbp_mobility (@var{m}, @var{x}, @var{t})
## What the constraints of a scene leave free at a state, and which reactions
## they determine.
##
## @var{x} are the @var{nx} states (or the @var{nq} coordinates alone) of the
## model @var{m} at the time @var{t} [s] (0 by default), closed
## (@code{gsmbp_assemble}).  @var{r} has the fields
##
## @table @code
## @item gruebler
## freedoms by counting: speeds of the tree less the rows that the cut joints
## have by their types (drives and rolling are not counted)
## @item rows, rank
## constraint rows that are kept, and how many are independent at @var{x}
## @item mobility
## true freedoms at @var{x}: speeds less @code{rank}
## @item redundant
## @code{rows} - @code{rank}: so many multipliers may be chosen at will
## @item unique
## for every multiplier: true where the motion determines it
## @item removed
## rows that were left out of the equations, with the reason
## @item singular
## the singular values of the Jacobian, rows scaled to length one
## @end table
##
## Without an output argument this is printed.  Reactions that are not unique
## come out of the simulation as the least of all that fit.
## @seealso{gsmbp_assemble, gsmbp_linear}
## @end deftypefn

function r = gsmbp_mobility (m, x, t = 0)
  if (nargin < 2)
    print_usage ();
  endif
  who = "gsmbp_mobility";
  gsmbp__model (who, m);
  d = m.sizes;
  t = gsmbp__vector (who, "t", t, 1);
  if (isnumeric (x) && numel (x) == d.nq)
    x = [x(:); zeros(d.nx - d.nq, 1)];
  endif
  q = gsmbp__vector (who, "x", x, d.nx, sprintf (" (the states of %s, or its %d coordinates)", m.name, d.nq))(1:d.nq);
  one = struct ("gruebler", d.nu, "rows", 0, "rank", 0, "mobility", d.nu, "redundant", 0, "unique", true (1, 0), "removed", struct ([]), "singular", []);
  if (isfield (m, "mobility") && isstruct (m.mobility))
    one.gruebler = m.mobility.gruebler;
    one.removed = m.removed;
  endif
  if (d.nlam > 0)
    [~, ~, H] = m.con (t, q, zeros (d.nu, 1));
    ## the rows on positions: speeds do not matter here
    [names, scaled, found] = gsmbp__residuals (m, t, [q; zeros(d.nx - d.nq, 1)]);
    places = cellfun (@isempty, strfind (names, "rate of "));
    if (! all (abs (scaled(places)) <= 1e-6))
      error ("gsmbp:start", "gsmbp_mobility: %s: expected a closed state at t = %.9g s, found %s; close it by gsmbp_assemble", m.name, t,
             gsmbp__worst (names(places), scaled(places), found(places), 1e-6));
    endif
    ## rows have units of their own: a row counts by its direction
    size_ = sqrt (sum (H .^ 2, 2));
    size_(size_ == 0) = 1;
    [U, S, ~] = svd (H ./ size_);
    s = diag (S(1:min (size (S)),1:min (size (S))));
    one.singular = s;
    one.rows = d.nlam;
    one.rank = sum (s > 1e-7 * max ([s; eps]));
    one.mobility = d.nu - one.rank;
    one.redundant = one.rows - one.rank;
    one.unique = (sqrt (sum (U(:,one.rank+1:end) .^ 2, 2)) < 1e-6)';
  endif
  if (nargout > 0)
    r = one;
  else
    show (m, one);
  endif
endfunction

function show (m, r)
  printf ("%s: mobility %d by the rank of its constraints here, %d by counting (Gruebler)\n", m.name, r.mobility, r.gruebler);
  printf ("  %d constraint rows, %d independent, %d redundant\n", r.rows, r.rank, r.redundant);
  for k = 1:numel (r.removed)
    printf ("  %s is left out: %s\n", r.removed(k).row, r.removed(k).reason);
  endfor
  if (r.redundant > 0)
    printf ("  not unique: %s\n", strjoin (m.multipliers(! r.unique), ", "));
    unique_ = m.multipliers(r.unique);
    if (isempty (unique_))
      unique_ = {"none"};
    endif
    printf ("  unique: %s\n", strjoin (unique_, ", "));
  endif
endfunction

%!error <Invalid call> gsmbp_mobility ()
