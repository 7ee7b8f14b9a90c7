;;; kernel/files.lisp: names, lines and processes for the one writer of files of Maxima
;;; (kernel/files.mac).
(in-package :maxima)

(defun $gs__shell_word (s)
  (with-output-to-string (out)
    (write-char #\' out)
    (loop for c across s do (if (char= c #\') (write-string "'\\''" out) (write-char c out)))
    (write-char #\' out)))
;; the exit code of a command of the shell. Maxima 5.49 on GCL runs that of system without a shell.
(defun $gs__exit_code (command)
  (let ((code #+gcl (si::system command) #-gcl (mfuncall '$system command)))
    #+sbcl
    (when (sb-ext:process-p code) (setq code (sb-ext:process-exit-code code)))
    (cond ((not (integerp code)) 1) ((> code 255) (ash code -8)) (t code))))
;; the exit code of a task of share/make/place, which says nothing; 40 words at a time, because the
;; command line of GCL is short. Lisp ignores Ctrl-C while a process runs; the process reports it,
;; by 130, or by 0 where it had not yet begun (77 is done).
(defun $gs__place_code (task words)
  (let ((script (concatenate 'string (symbol-value '$gs__share) "make/place")))
    (do ((l (cdr words) (nthcdr 40 l)) (code 0))
        ((or (null l) (plusp code)) code)
      (setq code
              ($gs__exit_code
               (format nil "~{~a~^ ~}"
                       (mapcar #'$gs__shell_word
                               (list* script "" task (subseq l 0 (min 40 (length l))))))))
      (case code
        ((0 130) (gs-interrupt))
        (77 (setq code 0))))))
;; a folder, made if it is not there; what fails is found when its files are written
(defun $gs__make_folder (folder)
  (ignore-errors (ensure-directories-exist (concatenate 'string ($gs__folder folder) "/")))
  '$done)
;; the file that a name means, seen from everywhere: a symbolic link is followed
(defun $gs__real_file (path)
  (if (probe-file path)
      ($gs__whole_path path)
      (let ((folder ($gs__directory path)))
        (concatenate 'string ($gs__whole_path folder) (gs-file-part path)))))
(defun gs-file-part (path)
  (let ((k (position #\/ path :from-end t))) (if k (subseq path (1+ k)) path)))
;; <folder>/.new-<process>-<name>
(defun $gs__beside (path)
  (format nil "~a.new-~d-~a" ($gs__directory path) (gs-session-id) (gs-file-part path)))
(defun gs-session-id ()
  #+gcl (si::getpid)
  #+ecl (ext:getpid)
  #+sbcl (sb-unix:unix-getpid)
  #-(or gcl ecl sbcl) (random 1000000000 (make-random-state t)))
;; the file has these lines and nothing else: `nil`, or the number of the first line that is not as
;; it should be. Lines may hold line ends.
(defun $gs__first_wrong_line (name lines)
  (let ((in ($openr name)) (n 0))
    (unwind-protect
        (flet ((same (text from to)
                 (let ((got (read-line in nil nil)))
                   (incf n)
                   (and got (string= got text :start2 from :end2 to)))))
          (dolist (line (cdr lines))
            (do* ((from 0 (1+ to))
                  (to (position #\newline line) (position #\newline line :start from)))
                 ((null to) (unless (same line from nil) (return-from $gs__first_wrong_line n)))
              (unless (same line from to) (return-from $gs__first_wrong_line n))))
          (and (read-line in nil nil) (1+ n)))
      (close in))))
