## path = gsmbp__place (part, ...)
## The path of a file or folder of GSMBP, named by its place in the repository:
## gsmbp__place ("share", "report", "style.css"), gsmbp__place ("octave", "glue").
## The one place that knows that the functions lie in octave/ there (and in what `make install`
## puts), but at the top, beside gsmbp/ and share/, in the Octave package (share/make/package).

function path = gsmbp__place (varargin)
  persistent functions = fileparts (fileparts (mfilename ("fullpath")));
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
