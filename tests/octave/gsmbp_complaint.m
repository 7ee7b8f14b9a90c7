## text = gsmbp_complaint (F): the message of the error that F () ends with, "" if there is none.

function text = gsmbp_complaint (f)
  text = "";
  try
    f ();
  catch err
    text = err.message;
  end
end
