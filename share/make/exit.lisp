;;; For batch runs of share/make/maxima. Maxima on GCL collects garbage before it begins with a
;;; batch: 60 ms of a session that may need 90. That of the Lisp itself, when it needs room, stays.
#+gcl (setf (symbol-function 'si::gbc) #'(lambda (what) what))
;;; An exit code for Maxima 5.46, whose quit() takes no argument. A log without the last line was
;;; cut short: the disk is full.
(defun $gs__exit (code)
  (format t "~&end of the run~%")
  (finish-output)
  #+gcl (system:quit code)
  #+ecl (ext:quit code)
  #+sbcl (sb-ext:exit :code code :abort t)
  #-(or gcl ecl sbcl) (error "gs__exit: unknown Lisp, code ~a" code))
