;;; fortran/expressions.lisp: the printer of fortran/statements.mac: expressions as text of Fortran
;;; 77, counted as they are printed; statements as lines. The state of an emission (gsmbp__emission)
;;; is held in variables of Maxima.
(in-package :maxima)

(declaim
  (special $gsmbp__names $gsmbp__used $gsmbp__numbers $gsmbp__mul $gsmbp__add $gsmbp__div
           $gsmbp__sqrt $gsmbp__trig $gsmbp__body $gsmbp__block $gsmbp__own $gsmbp__where
           $gsmbp__taken $gsmbp__parts))

(defun $gsmbp__tally ()
  (gsmbp-list (list $gsmbp__mul $gsmbp__add $gsmbp__div $gsmbp__sqrt $gsmbp__trig)))
(defun $gsmbp__set_tally (tally)
  (destructuring-bind (m a d s f) (cdr tally)
    (setq $gsmbp__mul m $gsmbp__add a $gsmbp__div d $gsmbp__sqrt s $gsmbp__trig f)))

;;; --------------------------------------------------------------------------- sums, terms, factors

;;; any expression: a sum with a positive term ahead if it has one
(defun $gsmbp__sum_text (e)
  (if (symbolp e)
      (gsmbp-name-text e)
      (gsmbp-joined (cdr ($gsmbp__signed_pieces ($gsmbp__signed_terms e))) "")))

;;; the summands of e (one, if e is no sum) as [sign, text, summand], sign "+" or "-"; the first
;;; positive one ahead
(defun $gsmbp__signed_terms (e)
  (if (not (gsmbp-sum-p e))
      (gsmbp-list (list (gsmbp-signed-term e)))
      (let* ((terms (mapcar #'gsmbp-signed-term (cdr e)))
             (lead (find "+" terms :key #'cadr :test #'string=)))
        (incf $gsmbp__add (1- (length terms)))
        (gsmbp-list
          (if (or (null lead) (eq lead (car terms)))
              terms
              (cons lead (remove lead terms :test #'eq)))))))

;;; terms as pieces of text: "A", " + B*C", " - D"
(defun $gsmbp__signed_pieces (terms)
  (destructuring-bind (first &rest others) (cdr terms)
    (gsmbp-list (cons (if (string= (cadr first) "-") (gsmbp-text "-" (caddr first)) (caddr first))
                      (mapcar #'(lambda (x) (gsmbp-text " " (cadr x) " " (caddr x))) others)))))

(defun gsmbp-signed-term (e)
  (cond ((symbolp e) (gsmbp-list (list "+" (gsmbp-name-text e) e)))
        ((mnump e) (gsmbp-signed e (gsmbp-number-text (gsmbp-magnitude e)) e))
        ((gsmbp-product-p e)
         (let ((c (cadr e)))
           (if (mnump c)
               (gsmbp-signed c (gsmbp-product-text (gsmbp-magnitude c) (cddr e)) e)
               (gsmbp-signed 1 (gsmbp-product-text 1 (cdr e)) e))))
        (t (gsmbp-signed
             1 (if (gsmbp-power-p e) (gsmbp-product-text 1 (list e)) (gsmbp-factor-text e)) e))))
(defun gsmbp-signed (number text e)
  (gsmbp-list (list (if (gsmbp-negative-p number) "-" "+") text e)))

;;; a number >= 0 as constants: one, or two whose quotient it is; as a term (its division is
;;; counted)
(defun gsmbp-number-parts (r)
  (cdr (or (gethash r $gsmbp__numbers)
           (setf (gethash r $gsmbp__numbers) (mfuncall '$gsmbp__constants (gsmbp-exact r))))))
(defun gsmbp-number-text (r)
  (let ((p (gsmbp-number-parts r)))
    (when (cdr p) (incf $gsmbp__div))
    (gsmbp-joined p "/")))

;;; a number c > 0 times factors; powers with a negative exponent become divisors
(defun gsmbp-product-text (c factors)
  (let ((above nil) (below nil))
    (dolist (f factors)
      (cond ((symbolp f) (push (gsmbp-name-text f) above))
            ((not (gsmbp-power-p f)) (push (gsmbp-factor-text f) above))
            ((and (mnump (caddr f)) (gsmbp-negative-p (caddr f)) (not (eq (cadr f) '$%e)))
             (setq below (append (gsmbp-power-texts (cadr f) (gsmbp-minus (caddr f))) below)))
            (t (setq above (append (gsmbp-power-texts (cadr f) (caddr f)) above)))))
    (if (eql c 1) (gsmbp-fraction-text (reverse above) (reverse below))
      (gsmbp-scaled-text (gsmbp-exact c) (reverse above) (reverse below)))))

;;; the same with texts of the factors: a decimal fraction is a factor, 1/3 a divisor, 2/3 a factor
;;; (2.0D0/3.0D0)
(defun gsmbp-scaled-text (c above below)
  (let ((k (gsmbp-number-parts c)))
    (cond ((eql c 1) (gsmbp-fraction-text above below))
          ((null (cdr k)) (gsmbp-fraction-text (cons (car k) above) below))
          ((eql (cadr c) 1) (gsmbp-fraction-text above (cons (cadr k) below)))
          (below (gsmbp-fraction-text (cons (car k) above) (cons (cadr k) below)))
          (t (incf $gsmbp__div)
             (gsmbp-fraction-text (cons (gsmbp-text "(" (car k) "/" (cadr k) ")") above) nil)))))

(defun gsmbp-fraction-text (above below)
  (let ((text (if above (gsmbp-joined above "*") "1.0D0")))
    (when (cdr above) (incf $gsmbp__mul (1- (length above))))
    (cond ((null below) text)
          (t (incf $gsmbp__div) (incf $gsmbp__mul (1- (length below)))
             (if (cdr below)
                 (gsmbp-text text "/(" (gsmbp-joined below "*") ")")
                 (gsmbp-text text "/" (car below)))))))

;;; b^n as factors in reverse order; n > 0 if it is a number
(defun gsmbp-power-texts (b n)
  (if (eq b '$%e)
      (progn (incf $gsmbp__trig) (list (gsmbp-text "EXP(" ($gsmbp__sum_text n) ")")))
      (let ((h (if (mnump n) (gsmbp-times 2 (gsmbp-exact n)))))
        (cond ((not (integerp h))
               (incf $gsmbp__trig)
               (list (gsmbp-text (gsmbp-base-text b) "**" (gsmbp-factor-text n))))
              ((evenp h) (gsmbp-integer-power b (/ h 2)))
              (t (incf $gsmbp__sqrt)
                 (cons (gsmbp-text "SQRT(" ($gsmbp__sum_text b) ")")
                       (gsmbp-integer-power b (/ (1- h) 2))))))))

(defun gsmbp-integer-power (b n)
  (case n
    (0 nil)
    (1 (list (gsmbp-factor-text b)))
    (t (incf $gsmbp__mul (1- n)) (list (gsmbp-text (gsmbp-base-text b) "**" (format nil "~d" n))))))
(defun gsmbp-base-text (b)
  (if (gsmbp-power-p b) (gsmbp-text "(" ($gsmbp__sum_text b) ")") (gsmbp-factor-text b)))

(defun gsmbp-factor-text (e)
  (cond ((mnump e) (gsmbp-number-factor e))
        ((atom e) (gsmbp-name-text e))
        ((or (gsmbp-sum-p e) (gsmbp-product-p e)) (gsmbp-text "(" ($gsmbp__sum_text e) ")"))
        ((gsmbp-power-p e) (gsmbp-power-factor (cadr e) (caddr e) e))
        (t (gsmbp-call-text ($op e) (cdr e)))))

;;; a call of a function with its arguments
(defun gsmbp-call-text (f arguments)
  (let ((e (mfuncall '$assoc f (mfuncall '$gsmbp__functions))) (n (length arguments)))
    (unless e (mfuncall '$gsmbp__error $gsmbp__where "Fortran 77 has no function " f))
    (destructuring-bind (name arity) (cdr e)
      (when (if (eql arity 0) (< n 2) (/= n arity))
        (mfuncall '$gsmbp__error $gsmbp__where "wrong number of arguments of " f ": " n))
      (cond ((string= name "SQRT") (incf $gsmbp__sqrt))
            ((not (member name '("ABS" "MAX" "MIN" "ANINT" "GSFLR") :test #'string=))
             (incf $gsmbp__trig)))
      (gsmbp-text name "(" (gsmbp-joined (mapcar #'$gsmbp__sum_text arguments) ", ") ")"))))

(defun gsmbp-number-factor (e)
  (let* ((d $gsmbp__div) (s (gsmbp-number-text (gsmbp-magnitude e))))
    (cond ((gsmbp-negative-p e) (gsmbp-text "(-" s ")"))
          ((> $gsmbp__div d) (gsmbp-text "(" s ")"))
          (t s))))

;;; a power where one factor is wanted: x^2, sqrt(x) and exp(x) are one; 1/x and x*sqrt(x) need
;;; parentheses
(defun gsmbp-power-factor (b n e)
  (if (and (mnump n) (gsmbp-negative-p n) (not (eq b '$%e)))
      (gsmbp-text "(" (gsmbp-product-text 1 (list e)) ")")
      (let ((l (gsmbp-power-texts b n)))
        (incf $gsmbp__mul (1- (length l)))
        (if (cdr l) (gsmbp-text "(" (gsmbp-joined (reverse l) "*") ")") (car l)))))

;;; the name of a symbol, which from now on counts as used
; hash table, symbol -> source: those that are loaded ahead of the first statement that uses them;
; or false
(defvar $gsmbp__late nil)
(defvar *gsmbp-due* nil)                 ; (name . source) of those that wait for the next statement
(defun gsmbp-name-text (x)
  (setf (gethash x $gsmbp__used) t)
  (let ((source (and $gsmbp__late (gethash x $gsmbp__late))))
    (when source
      (remhash x $gsmbp__late)
      (push (cons (gethash x $gsmbp__names) source) *gsmbp-due*)))
  (or (gethash x $gsmbp__names) (mfuncall '$gsmbp__nameless_text x)))

;;; ------------------------------------------------------------------------------------------ lines

;;; A statement given in pieces, broken between them where that will do, as lines of fixed form.
(defun $gsmbp__packed_lines (pieces)
  (let ((lines nil) (line (list "      ")) (width 66))
    (dolist (p (cdr pieces) (gsmbp-list (nreverse (cons (gsmbp-joined (nreverse line) "") lines))))
      (cond ((<= (length p) width) (push p line) (decf width (length p)))
            (t (push (gsmbp-joined (nreverse line) "") lines)
               (setq p (string-left-trim " " p) line (list p "     $   ") width (- 63 (length p)))
               (when (< width 0)
                 (return (mfuncall '$gsmbp__statement_lines (gsmbp-joined (cdr pieces) "") ""
                                   0))))))))

(defun $gsmbp__push (lines)
  (gsmbp-tick)
  (let ((due (reverse *gsmbp-due*)))
    (setq *gsmbp-due* nil)
    (dolist (d due) (gsmbp-push-line (gsmbp-load-line (car d) (cdr d)))))
  (dolist (l (cdr lines)) (gsmbp-push-line l)))
(defun gsmbp-push-line (l) (setq $gsmbp__body (gsmbp-list (cons l (cdr $gsmbp__body)))))
(defun gsmbp-load-line (name source)
  ($gsmbp__own_name name)
  (gsmbp-text "      " name " = " source))
(defun $gsmbp__assignment (target pieces)
  ($gsmbp__packed_lines (gsmbp-list (cons (gsmbp-text target " = " (cadr pieces)) (cddr pieces)))))

;;; --------------------------------------------------------------------- sines and cosines

(defun $gsmbp__own_name (n) (setq $gsmbp__own (gsmbp-list (cons n (cdr $gsmbp__own)))))

;;; the declaration of some names, or several if one would need more than 20 lines
(defun $gsmbp__declaration (type names) (gsmbp-list (gsmbp-declared type (cdr names))))
(defun gsmbp-declared (type names)
  (let* ((n (length names)) (half (floor n 2))
         (lines (if (<= 1 n 200)
                    (cdr ($gsmbp__packed_lines
                           (gsmbp-list
                             (cons (gsmbp-text type (car names) (if (cdr names) "," ""))
                                   (maplist #'(lambda (l)
                                                (gsmbp-text " " (car l) (if (cdr l) "," "")))
                                            (cdr names)))))))))
    (cond ((null names) nil)
          ((and lines (<= (length lines) 20)) lines)
          (t (mapcan #'(lambda (part) (gsmbp-declared type (cdr part)))
                     (cdr ($gsmbp__cut_at (gsmbp-list names) half)))))))

;;; a text filled into lines of at most 72 characters: `head` ahead of the first, `tail` ahead of
;;; the others
(defun $gsmbp__filled (text head tail)
  (let ((lines nil) (line (list head)) (width (length head)))
    (dolist (w (gsmbp-split text)
               (gsmbp-list
                 (nreverse (cons (string-right-trim " " (gsmbp-joined (nreverse line) "")) lines))))
      (cond ((null (cdr line)) (push w line) (incf width (length w)))
            ((<= (+ width 1 (length w)) 72)
             (push " " line)
             (push w line)
             (incf width (1+ (length w))))
            (t (push (gsmbp-joined (nreverse line) "") lines)
               (setq line (list w tail) width (+ (length tail) (length w))))))))
(defun gsmbp-split (text)                ; its words
  (let ((words nil) (from 0))
    (loop
      (let ((to (position #\Space text :start from)))
        (unless (eql from (or to (length text))) (push (subseq text from to) words))
        (unless to (return (nreverse words)))
        (setq from (1+ to))))))

;;; the right sides that are text
(defun $gsmbp__code_texts (code) (gsmbp-list (remove-if-not #'stringp (mapcar #'caddr (cdr code)))))

;;; the code with the sines and cosines ahead whose arguments are known at once
(defun $gsmbp__trig_first (load code)
  (let ((ready (make-hash-table :test #'eq)) (front nil) (back nil))
    (dolist (l (cdr load)) (setf (gethash (cadr l) ready) t))
    (dolist (c (cdr code) (gsmbp-list (append (reverse front) (reverse back))))
      (destructuring-bind (s e heading) (cdr c)
        (cond ((and (member heading '($trig "trig") :test #'equal)
                    (every #'(lambda (x) (gethash x ready)) (cdr ($gsmbp__symbols e))))
               (push c front)
               (setf (gethash s ready) t))
              (t (push c back)))))))

;;; ------------------------------------------------------------------------------------------ names

;;; Names for the loaded symbols [symbol, source]; a source that is an argument itself is used as it
;;; stands.
(defun $gsmbp__name_loads (load arguments)
  (dolist (l (cdr load))
    (let ((source (string-upcase (caddr l))))
      (setf (gethash (cadr l) $gsmbp__names)
            (if (member source (cdr arguments) :test #'string=) source ($gsmbp__fresh (cadr l)))))))

;;; the assignments of those whose symbol was printed or whose name the hash table raw holds
(defun $gsmbp__loads (load raw)
  (let ((lines nil))
    (dolist (l (cdr load) (gsmbp-list (nreverse lines)))
      (let ((n (gethash (cadr l) $gsmbp__names)))
        (when (and (string/= n (string-upcase (caddr l)))
                   (or (gethash (cadr l) $gsmbp__used) (gethash n raw)))
          (push (gsmbp-load-line n (caddr l)) lines))))))

;;; hash table, symbol -> source, of the loaded symbols but those whose name the hash table raw
;;; holds
(defun $gsmbp__to_load_late (load raw)
  (let ((h (make-hash-table :test #'eq)))
    (dolist (l (cdr load) h)
      (let ((n (gethash (cadr l) $gsmbp__names)))
        (unless (or (string= n (string-upcase (caddr l))) (gethash n raw))
          (setf (gethash (cadr l) h) (caddr l)))))))

;;; A free name for a symbol: its own in capitals, else with _ behind it, else _2, _3, ...
(defun $gsmbp__fresh (symbol)
  (let* ((base (gsmbp-fit (string-upcase ($sconcat symbol)))) (n base) (k 1))
    (loop
      (unless (gethash n $gsmbp__taken) (return))
      (setq n (if (= k 1) (gsmbp-text base "_") (format nil "~a_~d" base k)) k (1+ k)))
    (setf (gethash n $gsmbp__taken) t)
    n))
(defun gsmbp-fit (s)
  (let ((c (substitute-if-not #\_ #'gsmbp-word-character-p s)))
    (unless (gsmbp-letter-p (char c 0)) (setq c (gsmbp-text "X" c)))
    (subseq c 0 (min 26 (length c)))))
