;;; emit/names.lisp: the names of symbols in a text, and what is loaded under them.
(in-package :maxima)

;;; A free name for a symbol: its own in the letters of the language, without the private prefix,
;;; else with _ behind it, else _2, _3, ... What is occupied has true, or the number that is to be
;;; tried next.
(defun $gs__fresh (symbol)
  (let* ((base (gs-base-name symbol)) (n base)
         (held (gethash base $gs__occupied)) (k (if (integerp held) held 1)))
    (loop
      (unless (gethash n $gs__occupied) (return))
      (setq n (if (= k 1) (gs-text base "_") (format nil "~a_~d" base k)) k (1+ k)))
    (setf (gethash n $gs__occupied) t)
    (when held (setf (gethash base $gs__occupied) k))
    n))
(defun gs-base-name (symbol)
  (let ((text (if (symbolp symbol) (gs-shown-name symbol) ($sconcat symbol))))
    (gs-fit (gs-said '$cased (gs-public-text text)))))
(defun gs-public-text (s)
  (if (string-equal "GS__" (subseq s 0 (min 4 (length s)))) (subseq s 4) s))
;;; five characters shorter than the longest name, for what stands behind it
(defun gs-fit (s)
  (let ((c (if (every #'gs-word-character-p s) s
             (substitute-if-not #\_ #'gs-word-character-p s))))
    (unless (gs-letter-p (char c 0)) (setq c (gs-text (gs-said '$cased "X") c)))
    (subseq c 0 (min (- (gs-said-of '$longest) 5) (length c)))))

;;; a variable that the routine declares; the variable of a symbol, a new one if it has none
(defun $gs__own_name (n) (setq $gs__own (gs-list (cons n (cdr $gs__own)))))
(defun gs-target (s)
  (or (gethash s $gs__names)
      (let ((n ($gs__fresh s))) ($gs__own_name n) n)))
;;; a variable at the left of an assignment, which declares it if it is new and the language does so
(defun gs-opened (n new) (if (and new $gs__declares) (gs-text (cadr $gs__declares) n) n))
(defun gs-new-p (s) (not (gethash s $gs__names)))

;;; ------------------------------------------------------------------------------------------ uses

;;; a symbol has its value from here on, in the variable n
(defun gs-give (s n delay)
  (setf (gethash s $gs__delays) (max delay (* 2 (hash-table-count $gs__delays))))
  (setf (gethash s $gs__names) n))

;;; the name of a symbol, which from now on counts as used
(defun gs-name-text (x)
  (setf (gethash x $gs__used) t)
  (let ((source (and $gs__late (gethash x $gs__late))))
    (when source
      (remhash x $gs__late)
      (push (cons (gethash x $gs__names) source) $gs__due)))
  (or (gethash x $gs__names) (mfuncall '$gs__nameless_text x)))

;;; ----------------------------------------------------------------------------------------- loads

(defun gs-place-text (place) (gs-said '$value_ place))

;;; Names for the loaded symbols [symbol, place]; a place that is an argument itself is used as it
;;; stands.
(defun $gs__name_loads (load arguments)
  (dolist (l (cdr load))
    (let ((source (caddr l)))
      (setf (gethash (cadr l) $gs__names)
            (if (and (stringp source) (member source (cdr arguments) :test #'string=))
                (gs-place-text source)
                ($gs__fresh (cadr l)))))))

;;; does a loaded symbol have a variable of its own?
(defun gs-copied-p (l) (not (string= (gethash (cadr l) $gs__names) (gs-place-text (caddr l)))))

;;; the assignments of those whose symbol was printed
(defun $gs__loads (load)
  (gs-list
    (loop for l in (cdr load)
          when (and (gethash (cadr l) $gs__used) (gs-copied-p l))
          append (gs-load-lines (gethash (cadr l) $gs__names) (caddr l)))))
(defun gs-load-lines (name source)
  ($gs__own_name name)
  (cdr (gs-said '$statement
                (gs-list (list (gs-text (gs-opened name t) " = " (gs-place-text source)))))))

;;; hash table, symbol -> place, of the loaded symbols
(defun $gs__to_load_late (load)
  (let ((h (make-hash-table :test #'eq)))
    (dolist (l (cdr load) h)
      (when (gs-copied-p l) (setf (gethash (cadr l) h) (caddr l))))))

;;; [name, meaning] of those whose symbol was printed and whose place in CST has a meaning;
;;; meanings: hash table, number of the place -> text
(defun $gs__used_constants (load meanings)
  (let ((used nil))
    (dolist (l (cdr load) (gs-list (nreverse used)))
      (let ((text (gs-meaning (caddr l) meanings)))
        (when (and text (gethash (cadr l) $gs__used))
          (push (gs-list (list (gethash (cadr l) $gs__names) text)) used))))))
(defun gs-meaning (place meanings)
  (and (gs-place-p place)
       (string= (cadr place) "CST")
       (gethash (caddr place) meanings)))
