## path = gs.files.own_place (part, ...)
## The path of a file or folder of GSMBP, named by its place in the repository:
## gs.files.own_place ("share", "report", "style.css"), gs.files.own_place ("octave", "glue").
## The one place that knows that the functions lie in octave/ there (and in what `make install`
## puts), but at the top, beside gsmbp/ and share/, in the Octave package (share/make/package).

function path = own_place (varargin)
  persistent functions = fileparts (fileparts (fileparts (mfilename ("fullpath"))));
  persistent top = top_of (functions);
  if (strcmp (varargin{1}, "octave"))
    path = fullfile (functions, varargin{2:end});
  else
    path = fullfile (top, varargin{:});
  endif
endfunction

function top = top_of (functions)
  top = functions;
  if (! isfolder (fullfile (functions, "share")))
    top = fileparts (functions);
  endif
endfunction
