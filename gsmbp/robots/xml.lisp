;;; robots/xml.lisp: XML as lists, by share/urdf/read; decimals as they are typed in a file.
(in-package :maxima)

;;; The elements of an XML file and the liberties that are taken where `lenient` is true, with
;;; their lines: [[tag, line, [[attribute, value], ...], [child, ...]], [text, ...]]; or a string:
;;; what is wrong, with its line. `reader` is the program, `folder` a name that no file has.
(defun $gs__xml_elements (reader file folder lenient)
  (let ((list (concatenate 'string folder "/list")))
    ($gs__exit_code
     (format nil "sh ~a ~a ~a~:[~; lenient~]" ($gs__shell_word reader) ($gs__shell_word file)
             ($gs__shell_word folder) lenient))
    (if (probe-file list)
        (destructuring-bind (tree notes) (gs-read-list list)
          (delete-file list)
          ($gs__exit_code (format nil "rmdir ~a" ($gs__shell_word folder)))
          (cond ((not (and (consp tree)
                           (stringp (if (eq (car tree) :error) (caddr tree) (car tree)))))
                 "the file cannot be parsed")
                ((eq (car tree) :error)
                 (gs-line-text (cdr tree)))
                (t (list '(mlist simp) (gs-xml-node tree)
                         (cons '(mlist simp) (mapcar #'gs-line-text notes))))))
        "the reader of XML (share/urdf/read) cannot be run")))

;;; a folder of this process, as share/make/place names those that it removes when their process is
;;; gone: two sessions that begin in one second have the same random numbers
(defun $gs__new_folder (above)
  (format nil "~a/gsmbp-~d-~d" above (gs-session-id) (random 1000000000 (make-random-state t))))

;;; a text with the number of its line, 0 for none
(defun gs-line-text (said)
  (format nil "~:[line ~a: ~;~*~]~a" (eql (car said) 0) (car said) (cadr said)))

;;; (list notes): the list of a file, and the notes (:note line text) before it as (line text)
(defun gs-read-list (file)
  (with-open-file (in file)
    (let ((*read-eval* nil) (*readtable* (copy-readtable nil)) (*read-base* 10) (notes nil))
      (loop for x = (read in nil nil)
            while (and (consp x) (eq (car x) :note)) do (push (cdr x) notes)
            finally (return (list x (nreverse notes)))))))

(defun gs-xml-node (node)
  (destructuring-bind (tag line attributes children) node
    (list '(mlist simp) tag line
          (cons '(mlist simp)
                (mapcar #'(lambda (a) (list '(mlist simp) (car a) (cdr a))) attributes))
          (cons '(mlist simp) (mapcar #'gs-xml-node children)))))

;;; the children of an element that have the tag
(defun $gs__xml_all (e tag)
  (cons '(mlist simp)
        (remove-if-not #'(lambda (c) (equal (cadr c) tag)) (cdr (nth 4 e)))))
;;; attributes, [[name, text], ...]; one of them, or false
(defun $gs__xml_attributes (e) (nth 3 e))
(defun $gs__xml_get (e name)
  (caddr (find name (cdr (nth 3 e)) :key #'cadr :test #'equal)))
;;; the n numbers of an attribute; false where it is missing or has others
(defun $gs__xml_numbers (e name n)
  (let* ((text (and e ($gs__xml_get e name)))
         (l (and text (mapcar #'$gs__typed_number (cdr ($gs__blank_words text))))))
    (and l (= (length l) n) (notany #'null l) (cons '(mlist simp) l))))
;;; the numbers of attributes, one each; false where one is missing or has others
(defun $gs__xml_values (e names)
  (let ((l (mapcar #'(lambda (name) (cadr ($gs__xml_numbers e name 1))) (cdr names))))
    (and (notany #'null l) (cons '(mlist simp) l))))
;;; [xyz, rpy] of the child `origin`, 0 where they are missing; false where something else is there
(defun $gs__xml_origin (e)
  (let* ((all (and e (cdr ($gs__xml_all e "origin")))) (o (car all)) (zero '((mlist simp) 0 0 0)))
    (flet ((part (name) (if (and o ($gs__xml_get o name)) ($gs__xml_numbers o name 3) zero)))
      (let ((xyz (part "xyz")) (rpy (part "rpy")))
        (and xyz rpy (null (cdr all)) (not (and o ($gs__xml_get o "quat_xyzw")))
             (list '(mlist simp) xyz rpy))))))

;;; The value of a statement as text, evaluated as if no symbol in it had a value in the session.
;;; Maxima takes a symbol out of its list `values` where a function has it as a local variable
;;; meanwhile: afterwards it is there again.
(defun $gs__with_no_values (text)
  (let* ((statement (mfuncall '$parse_string text))
         (symbols (remove-if-not #'boundp (intersection (gs-symbols-in statement) (cdr $values))))
         (values (mapcar #'symbol-value symbols)))
    (unwind-protect (progn (mapc #'makunbound symbols) (meval statement))
      (mapc #'set symbols values)
      (dolist (s symbols) (add2lnc s $values)))))
(defun gs-symbols-in (e)
  (cond ((consp e) (delete-duplicates (mapcan #'gs-symbols-in (cdr e))))
        ((symbolp e) (list e))))

;;; The number of a text such as -1.5e-3, exact; false if it is none, or beyond what a double holds.
(defun $gs__typed_number (s)
  (let* ((e (position #\e s :test #'char-equal))
         (mantissa (gs-plain-decimal (subseq s 0 e)))
         (power (if e (gs-plain-integer (subseq s (1+ e))) 0)))
    (when (and mantissa power (< (abs power) 700))
      (let ((r (* mantissa (expt 10 power))))
        (cond ((> (abs r) (expt 10 300)) nil)
              ((integerp r) r)
              (t (list '(rat simp) (numerator r) (denominator r))))))))
;;; digits with a sign, a point among them; nil for anything else
(defun gs-plain-decimal (s)
  (let* ((point (position #\. s)) (whole (if point (remove #\. s :count 1) s))
         (n (gs-plain-integer whole)))
    (and n (< (length s) 400) (/ n (expt 10 (if point (- (length s) point 1) 0))))))
(defun gs-plain-integer (s)
  (let ((digits (string-left-trim "+-" s)))
    (and (plusp (length digits)) (<= (- (length s) (length digits)) 1) (every #'digit-char-p digits)
         (* (if (char= (char s 0) #\-) -1 1) (parse-integer digits)))))

;;; the words of a text, apart by blanks, tabs or ends of lines
(defun $gs__blank_words (s)
  (let ((words nil) (word nil))
    (flet ((end () (when word (push (coerce (nreverse word) 'string) words) (setq word nil))))
      (loop for c across s
            do (if (member c '(#\Space #\Tab #\Newline #\Return)) (end) (push c word)))
      (end)
      (cons '(mlist simp) (nreverse words)))))

;;; An exact number as a decimal: 0.02, 1.5e-7; a fraction where it has no end.
(defun $gs__typed_text (r)
  (let* ((q (gs-rational r)) (d (gs-digits (abs q))))
    (cond ((integerp q) (format nil "~d" q))
          ((null d) (format nil "~d/~d" (numerator q) (denominator q)))
          (t (concatenate 'string (if (minusp q) "-" "") (gs-decimal-text (car d) (cdr d)))))))
;;; (n . k) with q = n/10^k, or nil
(defun gs-digits (q)
  (let ((d (and (plusp q)
                ($gs__finite_decimal
                  (if (integerp q) q (list '(rat simp) (numerator q) (denominator q)))))))
    (and (consp d) (cons (cadr d) (caddr d)))))
;;; n/10^k
(defun gs-decimal-text (n k)
  (let* ((digits (format nil "~d" n)) (many (length digits)))
    (cond ((<= many (- k 4))
           (format nil "~a~:[.~a~;~*~]e-~d" (char digits 0) (= many 1) (subseq digits 1)
                   (- k (1- many))))
          ((<= many k)
           (format nil "0.~a~a" (make-string (- k many) :initial-element #\0) digits))
          (t (format nil "~a.~a" (subseq digits 0 (- many k)) (subseq digits (- many k)))))))

;;; The same as Maxima reads it exactly: a decimal that a double tells from its neighbours, else
;;; n/10^k.
(defun $gs__exact_text (r)
  (let* ((q (gs-rational r)) (d (gs-digits (abs q))))
    (if (or (null d) (integerp q) (gs-read-as (abs q)))
        ($gs__typed_text r)
        (format nil "~:[~;-~]~d/10^~d" (minusp q) (car d) (cdr d)))))

;;; whether Maxima reads the decimal of q as q
(defun gs-read-as (q)
  (let ((x (mfuncall '$parse_string
                     ($gs__typed_text (list '(rat simp) (numerator q) (denominator q))))))
    (and (floatp x) (= q (gs-decimal x)))))

;;; whether Maxima would take the name for something of its own: a word of its grammar, a variable
;;; of its own that has a value, a constant
(defun $gs__is_maximas (text)
  (let ((s ($gs__symbol_of text)))
    (and (or (and (boundp s) (not (member s (cdr $values))))
             (get s 'op) (get s 'nud) (get s 'led) (get s 'sysconst) (kindp s '$constant))
         t)))
(defun $gs__symbol_of (text)
  (intern (concatenate 'string "$" (maybe-invert-string-case text)) :maxima))
