;; kernel/tables.lisp: hash tables on expressions, in Lisp.
;; gs__get gives false for a key that is not there.
(in-package :maxima)
(defun $gs__new_hash () (make-hash-table :test #'equal))
(defun $gs__get (h k) (values (gethash (if (atom k) k (gs-bare k)) h)))
(defun $gs__put (h k v) (setf (gethash (if (atom k) k (gs-bare k)) h) v))
;; a list or an expression without the heads and marks of Maxima, which are not always the same (and
;; Lisp's hash sees little beyond the first)
(defun gs-bare (k)
  (cond ((atom k) k)
        ((eq (caar k) 'mlist) (mapcar #'gs-bare (cdr k)))
        (t (cons (list (caar k)) (mapcar #'gs-bare (cdr k))))))
;; e without the marks that functions like ratsimp leave on it, so that equal expressions are equal
;; lists
(defun $gs__unmarked (e)
  (if (atom e)
      e
      (cons (if (member 'array (cdar e)) (list (caar e) 'simp 'array) (list (caar e) 'simp))
            (mapcar #'$gs__unmarked (cdr e)))))
;; a table with the same values; of a tape's `numbers` also the pairs in them, which change
(defun $gs__copied_hash (h)
  (let ((c (make-hash-table :test #'equal))) (maphash #'(lambda (k v) (setf (gethash k c) v)) h) c))
(defun $gs__copied_numbers (h)
  (let ((c (make-hash-table :test #'equal)))
    (maphash #'(lambda (k v) (setf (gethash k c) (copy-tree v))) h)
    c))
;; the elements of a list in the order in which they are first seen, each once
(defun $gs__first_seen (l) (cons '(mlist simp) (gs-first-seen (cdr l))))
(defun gs-first-seen (elements)
  (let ((seen (make-hash-table :test #'equal)))
    (loop for x in elements
          for key = (gs-bare x)
          unless (gethash key seen)
            collect x and do (setf (gethash key seen) t))))
;; the elements of a list under 1, 2, ...; as many of them as a list
(defun $gs__put_all (l)
  (let ((h ($gs__new_hash)) (k 0)) (dolist (x (cdr l) h) (setf (gethash (incf k) h) x))))
(defun $gs__all_of (h n) (cons '(mlist simp) (loop for k from 1 to n collect (gethash k h))))
;; a table that holds `true` under the texts of words, in lower case
(defun $gs__table_of_words (words)
  (let ((h ($gs__new_hash)))
    (dolist (w (cdr words) h) (setf (gethash (string-downcase ($sconcat w)) h) t))))
;; true if the table h holds one of the symbols of a list
(defun $gs__holds_one (h symbols)
  (do ((l (cdr symbols) (cdr l))) ((or (null l) (gethash (car l) h)) (and l t))))
;; e with every symbol that the table h holds replaced by what it holds; simplified, not evaluated
(defun $gs__replace (h e) (gs-tick) (if (zerop (hash-table-count h)) e (gs-replace h e)))
(defun gs-replace (h e)
  (cond ((symbolp e) (or (gethash e h) e))
        ((or (atom e) (eq (caar e) 'rat)) e)
        (t (let ((a nil))
             (dolist (x (cdr e)) (push (gs-replace h x) a))
             (simplifya (cons (list (caar e)) (nreverse a)) nil)))))
;; the value of e, a list too, by a table that holds numbers for its symbols; the table takes the
;; values of entries [symbol, expression] in their order, of those that it does not hold; number:
;; `$float` or `$bfloat`
(defun $gs__numeric_of (number h e)
  (if (and (consp e) (eq (caar e) 'mlist))
      (cons '(mlist simp) (mapcar #'(lambda (x) ($gs__numeric_of number h x)) (cdr e)))
      (funcall number ($gs__replace h e))))
(defun $gs__take_numeric (number h entries)
  (dolist (e (cdr entries) h)
    (unless (gethash (cadr e) h)
      (setf (gethash (cadr e) h) ($gs__numeric_of number h (caddr e))))))
(defun $gs__float_of (h e) ($gs__numeric_of '$float h e))
(defun $gs__take_values (h entries) ($gs__take_numeric '$float h entries))
;; a name without repeated slashes, which are no name to GCL 2.7; that of a folder, with none at its
;; end
(defun $gs__slashes (path)
  (if (stringp path) (gs-slashes path) path))
(defun gs-slashes (path)
  (coerce (loop for (c next) on (coerce path 'list)
            unless (and (eql c #\/) (eql next #\/)) collect c) 'string))
(defun $gs__folder (path) (string-right-trim "/" ($gs__slashes path)))
;; files: is there one of that name; names (without folder and extension) of those that match, in
;; order
(defun $gs__file_exists (name) (and (probe-file ($gs__slashes name)) t))
;; is there a folder of that name? The system is asked: `directory` of GCL reads +, (, ^, ... as a
;; pattern
(defun $gs__directoryp (name)
  #+gcl (eq (si::stat name) :directory)
  #+ecl (eq (si:file-kind name t) :directory)
  #-(or gcl ecl)
  (let ((p (probe-file name))) (and p (null (pathname-name p)) (null (pathname-type p)))))
(defun gs-file-names (part pattern)
  (cons '(mlist simp) (stable-sort (mapcar part (directory pattern)) #'string<)))
(defun $gs__file_names (pattern) (gs-file-names #'pathname-name pattern))
;; the same with what stands behind the dot
(defun $gs__whole_file_names (pattern) (gs-file-names #'file-namestring pattern))
;; the directory of a path, with its last slash; "./" if it names none
(defun $gs__directory (path)
  (let ((k (position #\/ path :from-end t))) (if k (subseq path 0 (1+ k)) "./")))
;; the folder of that name, seen from everywhere
(defun $gs__whole_path (name) (namestring (truename name)))
;; the rules of "^" in this session, as one thing that Maxima does not look into; and back to them
;; where no others are on top
(defun $gs__power_rules ()
  (vector (get 'mexpt 'operators) (mget 'mexpt 'rulenum) (mget 'mexpt 'oldrules)))
(defun $gs__power_rules_back (before)
  (dolist (s '($gs__s $gs__n)) (delete s $myoptions))
  (when (equal (get 'mexpt 'operators) (svref before 0))
    (mputprop 'mexpt (svref before 1) 'rulenum)
    (unless (svref before 2) (mremprop 'mexpt 'oldrules)))
  t)
