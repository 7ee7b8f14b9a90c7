## The opening of the driver of an example, which sources it in its first line: it puts this folder
## on the path and opens the driver's report.

addpath (fileparts (mfilename ("fullpath")));
open_report (dbstack ("-completenames")(2).file);
