;;; tape/names.lisp: the tape's names (see tape/namer.mac), in Lisp: every scalar of a derivation
;;; passes through here. An operand is a name: a symbol or a number, or one with a minus. An entry
;;; is an operation on names; same operation, same name.
(in-package :maxima)

;;; fields of the structure gsmbp__tape
(defmacro gsmbp-table (tp) `(nth 1 ,tp))
(defmacro gsmbp-entries (tp) `(nth 2 ,tp))
(defmacro gsmbp-nature (tp) `(nth 3 ,tp))
(defmacro gsmbp-used (tp) `(nth 4 ,tp))
(defmacro gsmbp-numbers (tp) `(nth 5 ,tp))
(defmacro gsmbp-count (tp) `(nth 7 ,tp))
(defmacro gsmbp-block (tp) `(nth 8 ,tp))

(defun gsmbp-sum-p (e) (and (consp e) (eq (caar e) 'mplus)))
(defun gsmbp-product-p (e) (and (consp e) (eq (caar e) 'mtimes)))
(defun gsmbp-name-or-number-p (e) (or (atom e) (eq (caar e) 'rat)))

;;; ----------------------------------------------------------------------------------------- tables

(defun gsmbp-key (e)
  (cond ((symbolp e) (mod (sxhash e) gsmbp-key-size))
        ((integerp e) (mod e gsmbp-key-size))
        ((consp e)
         (let ((k (gsmbp-key (caar e))))
           (dolist (x (cdr e) k) (setq k (mod (+ (* 31 k) (gsmbp-key x)) gsmbp-key-size)))))
        (t 0)))
;;; a pass that is off: every operation a new name (share), nothing depends on parameters alone
;;; (hoist)
(defun gsmbp-on (pass) (member pass (cdr (symbol-value '$gsmbp_passes)) :test #'eq))
(defun gsmbp-find (tp e key)
  (if (gsmbp-on '$share) (cdr (assoc e (gethash key (gsmbp-table tp)) :test #'equal))))
(defun gsmbp-keep (tp e key name) (push (cons e name) (gethash key (gsmbp-table tp))) name)

;;; True if an expression holds parameters and numbers only. (What Maxima gets must be true or
;;; false: it takes any other list for an expression, and on GCL looks into it until it crashes.)
(defun $gsmbp__constantp (tp e) (and (gsmbp-constant-p (gsmbp-nature tp) e) t))
(defun gsmbp-constant-p (nature e)
  (cond ((symbolp e)
         (or (and (eq (gethash e nature) '$constant) (gsmbp-on '$hoist)) ($constantp e)))
        ((atom e) t)
        ((eq (caar e) 'rat) t)
        (t (dolist (x (cdr e) t) (unless (gsmbp-constant-p nature x) (return nil))))))

;;; the symbols of an expression or a list that are no constants of Maxima, each once
(defun $gsmbp__symbols (e)
  (let ((l nil) (seen (if (and (consp e) (eq (caar e) 'mlist)) (make-hash-table :test #'eq))))
    (labels ((walk (e)
               (cond ((consp e) (mapc #'walk (cdr e)))
                     ((or (not (symbolp e))
                          (if seen (gethash e seen) (member e l :test #'eq))
                          ($constantp e))
                      nil)
                     (t (when seen (setf (gethash e seen) t)) (push e l)))))
      (walk e)
      (gsmbp-list (nreverse l)))))

;;; ------------------------------------------------------------------------------------------ signs

;;; true if the first term of e is negative: then e = -1*(something that starts positive)
(defun $gsmbp__starts_negative (e)
  (cond ((atom e) (and (numberp e) (minusp e)))
        ((mnump e) (minusp (cadr e)))
        ((eq (caar e) 'mtimes) (and (mnump (cadr e)) ($gsmbp__starts_negative (cadr e))))
        ((eq (caar e) 'mplus) ($gsmbp__starts_negative (cadr e)))))
(defun $gsmbp__negate (e)
  (if (gsmbp-sum-p e) (addn (mapcar #'gsmbp-minus (cdr e)) t) (gsmbp-minus e)))

;;; ------------------------------------------------------------------------------------------ names

;;; The name of an expression on the tape tp; hint: text for it, or (text . text).
(defun $gsmbp__tape_name (tp e hint)
  (cond ((gsmbp-name-or-number-p e) e)
        (($gsmbp__starts_negative e) (gsmbp-minus ($gsmbp__tape_name tp ($gsmbp__negate e) hint)))
        ((gsmbp-constant-p (gsmbp-nature tp) e)
         ($gsmbp__tape_entry tp ($gsmbp__unmarked e) "" '$constant))
        ((gsmbp-sum-p e) (gsmbp-tape-sum tp (cdr e) hint))
        ((gsmbp-product-p e) (gsmbp-tape-product tp (cdr e) hint))
        (t ($gsmbp__tape_entry
             tp
             (simplifya
               (cons (list (caar e)) (mapcar #'(lambda (x) ($gsmbp__tape_name tp x "")) (cdr e))) t)
             hint '$variable))))

;;; the name of an operation on names
(defun $gsmbp__tape_entry (tp e hint nature)
  (cond ((gsmbp-name-or-number-p e) e)
        (($gsmbp__starts_negative e)
         (gsmbp-minus ($gsmbp__tape_entry tp ($gsmbp__negate e) hint nature)))
        (t (let ((key (gsmbp-key e)))
             (or (gsmbp-find tp e key)
                 (let ((v ($gsmbp__tape_symbol tp (if (eq nature '$constant) "k" hint))))
                   (setf (gethash v (gsmbp-nature tp)) nature)
                   ($gsmbp__tape_write tp v e)
                   (gsmbp-keep tp e key v)))))))

(defun $gsmbp__tape_write (tp v e)
  (gsmbp-tick)
  (incf (gsmbp-count tp))
  (setf (gethash v (gsmbp-entries tp))
        (gsmbp-list (list v e (gsmbp-block tp) (gsmbp-count tp) ($gsmbp__symbols e)))))
(defun gsmbp-text-entry (s table key test) (assoc s (gethash key table) :test test))
(defun gsmbp-use-text (tp s key) (push (list s) (gethash key (gsmbp-used tp))))
(defun $gsmbp__use_texts (tp texts)
  (dolist (s (cdr texts)) (gsmbp-use-text tp s (gsmbp-text-key s))))

;;; a new symbol: the hint itself if it is free, else the hint with a number; no hint is z, and z
;;; and k always have a number
(defun $gsmbp__tape_symbol (tp hint)
  (let* ((stem (if (consp hint)
                   (concatenate 'string (car hint) (cdr hint))
                   (if (string= hint "") "z" hint)))
         (numbered (member stem '("z" "k") :test #'string=)) (numbers (gsmbp-numbers tp))
         (place (gsmbp-text-key stem))
         (last (or (gsmbp-text-entry stem numbers place #'string=)
                   (car (push (cons stem (if numbered 1 0)) (gethash place numbers))))) text key)
    (loop
      (setq text (gsmbp-numbered stem (cdr last) numbered) key (gsmbp-text-key text))
      (incf (cdr last))
      (unless (gsmbp-text-entry text (gsmbp-used tp) key #'string-equal) (return)))
    (gsmbp-use-text tp text key)
    (intern-invert-case (concatenate 'string "$" text))))
(defun gsmbp-numbered (stem n numbered)
  (cond ((= n 0) stem)
        (numbered (format nil "~a~d" stem n))
        (t (format nil (if (digit-char-p (char stem (1- (length stem)))) "~a_~d" "~a~d") stem
                   (1+ n)))))

;;; --------------------------------------------------------------------------------------- products

;;; a product: its constants as one constant, its variables two by two, the sign in front
(defun gsmbp-tape-product (tp factors hint)
  (let ((c 1) (x nil))
    (dolist (f factors)
      (if (gsmbp-constant-p (gsmbp-nature tp) f)
          (setq c (gsmbp-times c f))
          (let ((g (gsmbp-tape-factor tp f)))
            (when ($gsmbp__starts_negative g) (setq c (gsmbp-minus c) g (gsmbp-minus g)))
            (push g x))))
    (let ((k ($gsmbp__tape_name tp c "")))
      (gsmbp-tape-times
        tp k (gsmbp-tape-fold tp (nreverse x) (if (or (eql c 1) (eql c -1)) hint "")) hint))))

;;; constant times name
(defun gsmbp-tape-times (tp c v hint)
  (if (or (member c '(1 -1 0)) (eql v 1))
      (gsmbp-times c v)
      ($gsmbp__tape_entry tp (gsmbp-times c v) hint '$variable)))

;;; x1*x2*x3 ... as ((x1*x2)*x3) ...
(defun gsmbp-tape-fold (tp x hint)
  (let ((v (car x)))
    (do ((l (cdr x) (cdr l))) ((null l) v)
      (setq v ($gsmbp__tape_entry tp (gsmbp-times v (car l)) (if (cdr l) "" hint) '$variable)))))

;;; a factor: a name, or the name of a power of a name
(defun gsmbp-tape-factor (tp f)
  (cond ((atom f) f)
        ((eq (caar f) 'mexpt)
         ($gsmbp__tape_entry
           tp (power ($gsmbp__tape_name tp (cadr f) "") ($gsmbp__tape_name tp (caddr f) "")) ""
           '$variable))
        (t ($gsmbp__tape_name tp f ""))))

;;; ------------------------------------------------------------------------------------------- sums

;;; a term as (values constant-factor variable-factor)
(defun gsmbp-split-term (tp e)
  (let ((nature (gsmbp-nature tp)))
    (cond ((gsmbp-constant-p nature e) (values e 1))
          ((not (gsmbp-product-p e)) (values 1 e))
          (t (let ((c nil) (x nil))
               (dolist (f (cdr e)) (if (gsmbp-constant-p nature f) (push f c) (push f x)))
               (if c (values (gsmbp-multiply c) (gsmbp-multiply x)) (values 1 e)))))))

;;; a sum: terms with the same variable part are one term; the constants of a term are one constant
(defun gsmbp-tape-sum (tp terms hint)
  (let ((parts nil))
    (dolist (e terms)
      (multiple-value-bind (c x) (gsmbp-split-term tp e)
        (setq x ($gsmbp__tape_name tp x ""))
        (when ($gsmbp__starts_negative x) (setq x (gsmbp-minus x) c (gsmbp-minus c)))
        (let ((old (assoc x parts)))
          (if old (setf (cdr old) ($expand (gsmbp-sum (cdr old) c))) (push (cons x c) parts)))))
    ($gsmbp__tape_entry
      tp
      (gsmbp-plus
        (mapcar #'(lambda (p) (gsmbp-tape-times tp ($gsmbp__tape_name tp (cdr p) "") (car p) ""))
                parts)) hint '$variable)))

;;; ------------------------------------------------------------------------------ vectors, matrices

(defun gsmbp-hinted (hint more) (if (string= hint "") "" (cons hint more)))
(defun gsmbp-name-one ; nm: the structure gsmbp__namer(kind, rules, tape, registry)
(nm e hint)
  (cond ((atom e) e)
        ((eq (nth 1 nm) '$tape) ($gsmbp__tape_name (nth 3 nm) e hint))
        (t (mfuncall '$gsmbp__untaped_name nm e))))
(defun $gsmbp__name (nm e hint) (gsmbp-name-one nm e hint))
(defun $gsmbp__hint (&rest parts) (if (equal (car parts) "") "" (apply #'$sconcat parts)))
(defun $gsmbp__name_vector (nm v hint)
  (gsmbp-list
    (mapcar #'(lambda (e axis) (gsmbp-name-one nm e (gsmbp-hinted hint axis))) (cdr v)
            '("x" "y" "z"))))
(defun $gsmbp__name_matrix (nm a hint)
  (let ((i 0) (j 0))
    (gsmbp-list
      (mapcar #'(lambda (r)
                  (incf i)
                  (setq j 0)
                  (gsmbp-list
                    (mapcar #'(lambda (e)
                                (incf j)
                                (gsmbp-name-one nm e (gsmbp-hinted hint (format nil "~d~d" i j))))
                            (cdr r)))) (cdr a)))))
(defun $gsmbp__name_list (nm l)
  (gsmbp-list (mapcar #'(lambda (e) (gsmbp-name-one nm e "")) (cdr l))))

;;; A wrench [f, n], turned by R, about a point that lies at -s: [R f, R n + s x R f]
(defun $gsmbp__carried_wrench (nm r s fn force-hint moment-hint)
  (destructuring-bind (f n) (cdr fn)
    (setq f ($gsmbp__name_vector nm ($gsmbp__matvec r f) force-hint)
          n ($gsmbp__name_vector nm ($gsmbp__matvec r n) ""))
    (gsmbp-list
      (list f ($gsmbp__name_vector nm ($gsmbp__vadd n ($gsmbp__cross s f)) moment-hint)))))

;;; a symmetric matrix, its upper half named
(defun $gsmbp__symmetric (nm a hint)
  (let ((i 0) (upper nil) (rows nil))
    (dolist (r (cdr a))
      (let ((j i))
        (incf i)
        (push (mapcar #'(lambda (e)
                          (incf j)
                          (gsmbp-name-one
                            nm e (gsmbp-hinted hint (if (atom e) "" (format nil "~d~d" i j)))))
                      (nthcdr i r)) upper)))
    (setq upper (nreverse upper))
    (dotimes (k i (gsmbp-list (nreverse rows)))
      (let ((row nil))
        (dotimes (l k) (push (nth (- k l) (nth l upper)) row))
        (push (gsmbp-list (append (nreverse row) (nth k upper))) rows)))))

;;; The entries of M that a column, the wrench [f, n] of the direction d, has with the screws
;;; [direction, factor of f, factor of n], in place
(defun $gsmbp__add_screw_entries (nm m d screws fn)
  (let ((column (append (cdr (cadr fn)) (cdr (caddr fn)))))
    (dolist (o (cdr screws) m)
      (destructuring-bind (direction a b) (cdr o)
        ($gsmbp__add_to_matrix
          m d direction (gsmbp-name-one nm (gsmbp-inner (append (cdr a) (cdr b)) column) ""))))))

;;; The entries of M that the directions d and o of joints share (a mass matrix by rate), more by v,
;;; in place: see gsmbp__directions
(defun $gsmbp__add_to_matrix (m d o v)
  (let ((apart (not (alike1 d o))))
    (flet ((add (k l s)
             (let ((row (nth k m)))
               (setf (nth l row) (gsmbp-plus (list (nth l row) (gsmbp-times s v)))))))
      (dolist (a (cdr (nth 3 d)) m)
        (dolist (b (cdr (nth 3 o)))
          (destructuring-bind (k s) (cdr a)
            (destructuring-bind (l u) (cdr b)
              (add k l (gsmbp-times s u))
              (when apart (add l k (gsmbp-times s u))))))))))
