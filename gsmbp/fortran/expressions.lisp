;;; fortran/expressions.lisp: the printer of fortran/statements.mac: expressions as text of Fortran
;;; 77, counted as they are printed; statements as lines. The state of an emission (gs__emission)
;;; is held in variables of Maxima.
(in-package :maxima)

(declaim
  (special $gs__names $gs__used $gs__delays $gs__numbers $gs__n_mul $gs__n_add $gs__n_div
           $gs__n_sqrt $gs__n_trig $gs__body $gs__block $gs__own $gs__where
           $gs__occupied $gs__parts))

(defun $gs__tally ()
  (gs-list (list $gs__n_mul $gs__n_add $gs__n_div $gs__n_sqrt $gs__n_trig)))
(defun $gs__set_tally (tally)
  (destructuring-bind (m a d s f) (cdr tally)
    (setq $gs__n_mul m $gs__n_add a $gs__n_div d $gs__n_sqrt s $gs__n_trig f)))

;;; --------------------------------------------------------------------------- sums, terms, factors

;;; any expression: a sum with a positive term ahead if it has one
(defun $gs__sum_text (e)
  (if (symbolp e)
      (gs-name-text e)
      (gs-joined (cdr ($gs__signed_pieces ($gs__signed_terms e))) "")))

;;; the summands of e (one, if e is no sum) as [sign, text, summand], sign "+" or "-"; the first
;;; positive one ahead
(defun $gs__signed_terms (e)
  (if (not (gs-sum-p e))
      (gs-list (list (gs-signed-term e)))
      (let* ((terms (mapcar #'gs-signed-term (gs-as-ready (cdr e))))
             (lead (loop for x in terms when (string= (cadr x) "+") return x)))
        (incf $gs__n_add (1- (length terms)))
        (gs-list
          (if (or (null lead) (eq lead (car terms)))
              terms
              (cons lead (remove lead terms :test #'eq)))))))

;;; terms as pieces of text: "A", " + B*C", " - D"
(defun $gs__signed_pieces (terms)
  (destructuring-bind (first &rest others) (cdr terms)
    (gs-list (cons (if (string= (cadr first) "-") (gs-text "-" (caddr first)) (caddr first))
                   (mapcar #'(lambda (x) (gs-text " " (cadr x) " " (caddr x))) others)))))

(defun gs-signed-term (e)
  (cond ((symbolp e) (gs-list (list "+" (gs-name-text e) e)))
        ((mnump e) (gs-signed e (gs-number-text (gs-magnitude e)) e))
        ((gs-product-p e)
         (let ((c (cadr e)))
           (if (mnump c)
               (gs-signed c (gs-product-text (gs-magnitude c) (cddr e)) e)
               (gs-signed 1 (gs-product-text 1 (cdr e)) e))))
        (t (gs-signed
             1 (if (gs-power-p e) (gs-product-text 1 (list e)) (gs-factor-text e)) e))))
(defun gs-signed (number text e)
  (gs-list (list (if (gs-negative-p number) "-" "+") text e)))

;;; a number >= 0 as constants: one, or two whose quotient it is; as a term (its division is
;;; counted)
(defun gs-number-parts (r)
  (cdr (or (gethash r $gs__numbers)
           (setf (gethash r $gs__numbers) (mfuncall '$gs__constants (gs-exact r))))))
(defun gs-number-text (r)
  (let ((p (gs-number-parts r)))
    (when (cdr p) (incf $gs__n_div))
    (gs-joined p "/")))

;;; a number c > 0 times factors; powers with a negative exponent become divisors
(defun gs-product-text (c factors)
  (let ((above nil) (below nil))
    (dolist (f (gs-as-ready factors))
      (cond ((symbolp f) (push (gs-name-text f) above))
            ((not (gs-power-p f)) (push (gs-factor-text f) above))
            ((and (mnump (caddr f)) (gs-negative-p (caddr f)) (not (eq (cadr f) '$%e)))
             (setq below (append (gs-power-texts (cadr f) (gs-minus (caddr f))) below)))
            (t (setq above (append (gs-power-texts (cadr f) (caddr f)) above)))))
    (if (eql c 1) (gs-fraction-text (reverse above) (reverse below))
      (gs-scaled-text (gs-exact c) (reverse above) (reverse below)))))

;;; the same with texts of the factors: a decimal fraction is a factor, 1/3 a divisor, 2/3 a factor
;;; (2.0D0/3.0D0)
(defun gs-scaled-text (c above below)
  (let ((k (gs-number-parts c)))
    (cond ((eql c 1) (gs-fraction-text above below))
          ((null (cdr k)) (gs-fraction-text (cons (car k) above) below))
          ((eql (cadr c) 1) (gs-fraction-text above (cons (cadr k) below)))
          (below (gs-fraction-text (cons (car k) above) (cons (cadr k) below)))
          (t (incf $gs__n_div)
             (gs-fraction-text (cons (gs-text "(" (car k) "/" (cadr k) ")") above) nil)))))

(defun gs-fraction-text (above below)
  (let ((text (if above (gs-joined above "*") "1.0D0")))
    (when (cdr above) (incf $gs__n_mul (1- (length above))))
    (cond ((null below) text)
          (t (incf $gs__n_div) (incf $gs__n_mul (1- (length below)))
             (if (cdr below)
                 (gs-text text "/(" (gs-joined below "*") ")")
                 (gs-text text "/" (car below)))))))

;;; b^n as factors in reverse order; n > 0 if it is a number
(defun gs-power-texts (b n)
  (if (eq b '$%e)
      (progn (incf $gs__n_trig) (list (gs-text "EXP(" ($gs__sum_text n) ")")))
      (let ((h (if (mnump n) (gs-times 2 (gs-exact n)))))
        (cond ((not (integerp h))
               (incf $gs__n_trig)
               (list (gs-text (gs-base-text b) "**" (gs-factor-text n))))
              ((evenp h) (gs-integer-power b (/ h 2)))
              (t (incf $gs__n_sqrt)
                 (cons (gs-text "SQRT(" ($gs__sum_text b) ")")
                       (gs-integer-power b (/ (1- h) 2))))))))

(defun gs-integer-power (b n)
  (case n
    (0 nil)
    (1 (list (gs-factor-text b)))
    (t (incf $gs__n_mul (1- n)) (list (gs-text (gs-base-text b) "**" (format nil "~d" n))))))
(defun gs-base-text (b)
  (if (gs-power-p b) (gs-text "(" ($gs__sum_text b) ")") (gs-factor-text b)))

(defun gs-factor-text (e)
  (cond ((mnump e) (gs-number-factor e))
        ((atom e) (gs-name-text e))
        ((or (gs-sum-p e) (gs-product-p e)) (gs-text "(" ($gs__sum_text e) ")"))
        ((gs-power-p e) (gs-power-factor (cadr e) (caddr e) e))
        (t (gs-call-text ($op e) (cdr e)))))

;;; a call of a function with its arguments
(defun gs-call-text (f arguments)
  (let ((e (mfuncall '$assoc f (mfuncall '$gs__functions))) (n (length arguments)))
    (unless e (mfuncall '$gs__error $gs__where "Fortran 77 has no function " f))
    (destructuring-bind (name arity) (cdr e)
      (when (if (eql arity 0) (< n 2) (/= n arity))
        (mfuncall '$gs__error $gs__where "wrong number of arguments of " f ": " n))
      (cond ((string= name "SQRT") (incf $gs__n_sqrt))
            ((not (member name '("ABS" "SIGN" "MAX" "MIN" "ANINT" "GSFLR") :test #'string=))
             (incf $gs__n_trig)))
      (gs-text name (if (string= name "SIGN") "(1.0D0, " "(")
        (gs-joined (mapcar #'$gs__sum_text arguments) ", ") ")"))))

(defun gs-number-factor (e)
  (let* ((d $gs__n_div) (s (gs-number-text (gs-magnitude e))))
    (cond ((gs-negative-p e) (gs-text "(-" s ")"))
          ((> $gs__n_div d) (gs-text "(" s ")"))
          (t s))))

;;; a power where one factor is wanted: x^2, sqrt(x) and exp(x) are one; 1/x and x*sqrt(x) need
;;; parentheses
(defun gs-power-factor (b n e)
  (if (and (mnump n) (gs-negative-p n) (not (eq b '$%e)))
      (gs-text "(" (gs-product-text 1 (list e)) ")")
      (let ((l (gs-power-texts b n)))
        (incf $gs__n_mul (1- (length l)))
        (if (cdr l) (gs-text "(" (gs-joined (reverse l) "*") ")") (car l)))))

;;; ---------------------------------------------------------------------- the order of operands

;;; Operands in the order in which their values are ready: a processor that works a chain of
;;; additions from the left waits the least where what takes longest stands last. Those that are
;;; ready at once stay as they were.
(defun gs-as-ready (operands) (mapcar #'cdr (gs-by-delay operands)))
(defun gs-by-delay (operands)
  (stable-sort (mapcar #'(lambda (x) (cons (gs-delay x) x)) operands) #'< :key #'car))

;;; Clock cycles from the start of a routine until an expression has its value, as a processor that
;;; never waits for its units would have it: 4 for an addition or a product, 13 for a division,
;;; 18 for a root, 40 for another function. No statement begins before the processor has read those
;;; ahead of it, at two cycles each (gs-give).
(defun gs-delay (e)
  (cond ((symbolp e) (gethash e $gs__delays 0))
        ((atom e) 0)
        ((or (gs-sum-p e) (gs-product-p e))
         (let ((so-far nil))
           (dolist (p (gs-by-delay (remove -1 (cdr e))) so-far)
             (setq so-far (if so-far (+ 4 (max so-far (car p))) (car p))))))
        ((mnump e) 0)
        (t (+ (gs-delay-of e) (loop for x in (cdr e) maximize (gs-delay x))))))
(defun gs-delay-of (e)
  (cond ((not (gs-power-p e)) 40)
        ((integerp (caddr e)) (if (minusp (caddr e)) 13 4))
        (t 18)))
;;; a symbol has its value from here on, in the variable n
(defun gs-give (s n delay)
  (setf (gethash s $gs__delays) (max delay (* 2 (hash-table-count $gs__delays))))
  (setf (gethash s $gs__names) n))

;;; the name of a symbol, which from now on counts as used
; hash table, symbol -> source: those that are loaded ahead of the first statement that uses them;
; or false
(defvar $gs__late nil)
; (name . source) of those that wait for the next statement; bound by gs__emission, as all that an
; interrupt must not leave behind
(defvar $gs__due nil)
(defun gs-name-text (x)
  (setf (gethash x $gs__used) t)
  (let ((source (and $gs__late (gethash x $gs__late))))
    (when source
      (remhash x $gs__late)
      (push (cons (gethash x $gs__names) source) $gs__due)))
  (or (gethash x $gs__names) (mfuncall '$gs__nameless_text x)))

;;; ------------------------------------------------------------------------------------------ lines

;;; A statement given in pieces, broken between them where that will do, as lines of fixed form.
(defun $gs__packed_lines (pieces)
  (let ((lines nil) (line (list "      ")) (width 66))
    (dolist (p (cdr pieces) (gs-list (nreverse (cons (gs-joined (nreverse line) "") lines))))
      (cond ((<= (length p) width) (push p line) (decf width (length p)))
            (t (push (gs-joined (nreverse line) "") lines)
               (setq p (string-left-trim " " p) line (list p "     $   ") width (- 63 (length p)))
               (when (< width 0)
                 (return (mfuncall '$gs__statement_lines (gs-joined (cdr pieces) "") ""
                                   0))))))))

(defun $gs__push (lines)
  (gs-tick)
  (let ((due (reverse $gs__due)))
    (setq $gs__due nil)
    (dolist (d due) (gs-push-line (gs-load-line (car d) (cdr d)))))
  (dolist (l (cdr lines)) (gs-push-line l)))
(defun gs-push-line (l) (setq $gs__body (gs-list (cons l (cdr $gs__body)))))
(defun gs-load-line (name source)
  ($gs__own_name name)
  (gs-text "      " name " = " source))
(defun $gs__assignment (target pieces)
  ($gs__packed_lines (gs-list (cons (gs-text target " = " (cadr pieces)) (cddr pieces)))))

;;; --------------------------------------------------------------------- sines and cosines

(defun $gs__own_name (n) (setq $gs__own (gs-list (cons n (cdr $gs__own)))))

;;; the declaration of some names, or several if one would need more than 20 lines
(defun $gs__declaration (type names) (gs-list (gs-declared type (cdr names))))
(defun gs-declared (type names)
  (let* ((n (length names)) (half (floor n 2))
         (lines (if (<= 1 n 200)
                    (cdr ($gs__packed_lines
                           (gs-list
                             (cons (gs-text type (car names) (if (cdr names) "," ""))
                                   (maplist #'(lambda (l)
                                                (gs-text " " (car l) (if (cdr l) "," "")))
                                            (cdr names)))))))))
    (cond ((null names) nil)
          ((and lines (<= (length lines) 20)) lines)
          (t (mapcan #'(lambda (part) (gs-declared type (cdr part)))
                     (cdr ($gs__cut_at (gs-list names) half)))))))

;;; a text filled into lines of at most 72 characters: `head` ahead of the first, `tail` ahead of
;;; the others
(defun $gs__filled (text head tail)
  (let ((lines nil) (line (list head)) (width (length head)))
    (dolist (w (gs-split text)
               (gs-list
                 (nreverse (cons (string-right-trim " " (gs-joined (nreverse line) "")) lines))))
      (cond ((null (cdr line)) (push w line) (incf width (length w)))
            ((<= (+ width 1 (length w)) 72)
             (push " " line)
             (push w line)
             (incf width (1+ (length w))))
            (t (push (gs-joined (nreverse line) "") lines)
               (setq line (list w tail) width (+ (length tail) (length w))))))))
(defun gs-split (text)                ; its words
  (let ((words nil) (from 0))
    (loop
      (let ((to (position #\Space text :start from)))
        (unless (eql from (or to (length text))) (push (subseq text from to) words))
        (unless to (return (nreverse words)))
        (setq from (1+ to))))))

;;; the right sides that are text
(defun $gs__code_texts (code) (gs-list (remove-if-not #'stringp (mapcar #'caddr (cdr code)))))

;;; the statements among the entries [symbol, expression, block]: no symbol, text
(defun $gs__statement_texts (code)
  (gs-list (loop for c in (cdr code)
                 when (and (null (cadr c)) (stringp (caddr c))) collect (caddr c))))

;;; the code with the sines and cosines ahead whose arguments are known at once
(defun $gs__trig_first (load code)
  (let ((ready (make-hash-table :test #'eq)) (front nil) (back nil))
    (dolist (l (cdr load)) (setf (gethash (cadr l) ready) t))
    (dolist (c (cdr code) (gs-list (append (reverse front) (reverse back))))
      (destructuring-bind (s e heading) (cdr c)
        (cond ((and (member heading '($trig "trig") :test #'equal)
                    (loop for x in (cdr ($gs__symbols e)) always (gethash x ready)))
               (push c front)
               (setf (gethash s ready) t))
              (t (push c back)))))))

;;; ------------------------------------------------------------------------------------------ names

;;; Names for the loaded symbols [symbol, source]; a source that is an argument itself is used as it
;;; stands.
(defun $gs__name_loads (load arguments)
  (dolist (l (cdr load))
    (let ((source (string-upcase (caddr l))))
      (setf (gethash (cadr l) $gs__names)
            (if (member source (cdr arguments) :test #'string=) source ($gs__fresh (cadr l)))))))

;;; the assignments of those whose symbol was printed or whose name the hash table raw holds
(defun $gs__loads (load raw)
  (let ((lines nil))
    (dolist (l (cdr load) (gs-list (nreverse lines)))
      (let ((n (gethash (cadr l) $gs__names)))
        (when (and (string/= n (string-upcase (caddr l)))
                   (or (gethash (cadr l) $gs__used) (gethash n raw)))
          (push (gs-load-line n (caddr l)) lines))))))

;;; [name, meaning] of those whose symbol was printed and whose place has a meaning; meanings: hash
;;; table, place -> text
(defun $gs__used_constants (load meanings)
  (let ((used nil))
    (dolist (l (cdr load) (gs-list (nreverse used)))
      (let ((text (gethash (caddr l) meanings)))
        (when (and text (gethash (cadr l) $gs__used))
          (push (gs-list (list (gethash (cadr l) $gs__names) text)) used))))))

;;; hash table, symbol -> source, of the loaded symbols but those whose name the hash table raw
;;; holds
(defun $gs__to_load_late (load raw)
  (let ((h (make-hash-table :test #'eq)))
    (dolist (l (cdr load) h)
      (let ((n (gethash (cadr l) $gs__names)))
        (unless (or (string= n (string-upcase (caddr l))) (gethash n raw))
          (setf (gethash (cadr l) h) (caddr l)))))))

;;; A free name for a symbol: its own in capitals, without the private prefix, else with _ behind
;;; it, else _2, _3, ... What is occupied has true, or the number that is to be tried next.
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
    (gs-fit (gs-public-text (string-upcase text)))))
(defun gs-public-text (s)
  (if (eql (search "GS__" s) 0) (subseq s 4) s))
(defun gs-fit (s)
  (let ((c (if (every #'gs-word-character-p s) s
             (substitute-if-not #\_ #'gs-word-character-p s))))
    (unless (gs-letter-p (char c 0)) (setq c (gs-text "X" c)))
    (subseq c 0 (min 26 (length c)))))

;;; how many entries of the code, from its start on, are calls of GSSC
(defun $gs__leading_calls (code)
  (or (position-if-not #'$listp (cdr code) :key #'cadr) (length (cdr code))))
;;; the loads [symbol, place] whose symbol an expression of the code or a result uses
(defun $gs__loads_used (loads code result)
  (let ((used (make-hash-table :test #'eq)))
    (flet ((use (e)
             (unless (stringp e)
               (dolist (s (cdr ($gs__symbols e))) (setf (gethash s used) t)))))
      (dolist (c (cdr code)) (use (caddr c)))
      (dolist (r (cdr result)) (use (caddr r))))
    (gs-list (remove-if-not #'(lambda (l) (gethash (cadr l) used)) (cdr loads)))))
;;; what stands above the values of an array whose text this is
(defun $gs__title_of (text)
  (subseq text 0 (position-if #'(lambda (c) (find c ";:")) text)))
