;;; An exit code for Maxima 5.46, whose quit() takes no argument. A log without the last line was
;;; cut short: the disk is full.
(defun $gs__exit (code)
  (format t "~&end of the run~%")
  (finish-output)
  #+gcl (system:quit code)
  #+ecl (ext:quit code)
  #+sbcl (sb-ext:exit :code code :abort t)
  #-(or gcl ecl sbcl) (error "gs__exit: unknown Lisp, code ~a" code))
