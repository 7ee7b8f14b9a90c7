;;; What a Maxima session holds: session_snapshot() remembers the value and the rules of every
;;; user-visible symbol, session_changes(snapshot) lists the names whose value or rules differ now.
;;; Names of GSMBP, labels, and what Maxima itself notes down (the last error, the last part taken,
;;; the options that any block has bound) are left out.

(in-package :maxima)

(defun session-name (symbol)
  (let ((name (symbol-name symbol)))
    (and (> (length name) 1)
         (find (char name 0) "$%&")
         (not (search "GSMBP" (string-upcase name)))
         (not (search "GS__" (string-upcase name)))
         ; labels %i1, %o1
         (not (every (lambda (c) (or (digit-char-p c) (find c "$%ioIO"))) name))
         (not (member name
                      '("$_" "$__" "$%" "$%%" "$LABELS" "$LINENUM" "$VALUES" "$FUNCTIONS"
                             "$STRUCTURES" "$PROPS" "$LOAD_PATHNAME" "$SNAPSHOT" "$ARRAYS" "$MACROS"
                             "$PIECE" "$MYOPTIONS" "$ERROR") :test #'string=)))))

(defun session-state (symbol)
  (with-standard-io-syntax
    (let ((*print-circle* t) (*print-readably* nil))
      (prin1-to-string
        (list (if (boundp symbol) (symbol-value symbol) 'unbound)
              (mapcar (lambda (indicator) (get symbol indicator))
                      '(operators opers grad evfun evflag bindtest)))))))

(defun $session_snapshot ()
  (let ((table (make-hash-table :test 'eq)))
    (do-symbols
      (symbol :maxima)
      (when (session-name symbol) (setf (gethash symbol table) (session-state symbol))))
    (dolist (symbol '(mplus mtimes mexpt mquotient mminus %sin %cos %tan %derivative) table)
      (setf (gethash symbol table) (session-state symbol)))))

(defun $session_changes (table)
  (let ((changed nil))
    (maphash
      (lambda (symbol state)
        (unless (string= state (session-state symbol))
          (push (string-left-trim "$%" (symbol-name symbol)) changed)))
      table)
    (cons '(mlist) (sort changed #'string<))))
