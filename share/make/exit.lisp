;;; An exit code for Maxima 5.46, whose quit() takes no argument.
(defun $gsmbp__exit (code)
  (finish-output)
  #+gcl (system:quit code)
  #+ecl (ext:quit code)
  #+sbcl (sb-ext:exit :code code :abort t)
  #-(or gcl ecl sbcl) (error "gsmbp__exit: unknown Lisp, code ~a" code))
