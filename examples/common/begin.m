## The opening of the driver of an example: begin.m is sourced in its first line. It puts this folder
## on the path and opens the driver's report.

addpath (fileparts (mfilename ("fullpath")));
open_report (dbstack ("-completenames")(2).file);
