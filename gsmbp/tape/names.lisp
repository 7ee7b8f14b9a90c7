;;; tape/names.lisp: the tape's names (see tape/namer.mac), in Lisp: every scalar of a derivation
;;; passes through here. An operand is a name: a symbol or a number, or one with a minus. An entry
;;; is an operation on names; same operation, same name.
(in-package :maxima)

;;; fields of the structure gs__tape
(defmacro gs-table (tp) `(nth 1 ,tp))
(defmacro gs-entries (tp) `(nth 2 ,tp))
(defmacro gs-nature (tp) `(nth 3 ,tp))
(defmacro gs-used (tp) `(nth 4 ,tp))
(defmacro gs-numbers (tp) `(nth 5 ,tp))
(defmacro gs-count (tp) `(nth 7 ,tp))
(defmacro gs-block (tp) `(nth 8 ,tp))

(defun gs-name-or-number-p (e) (or (atom e) (eq (caar e) 'rat)))

;;; ----------------------------------------------------------------------------------------- tables

(defun gs-key (e)
  (cond ((symbolp e) (mod (sxhash e) gs-key-size))
        ((integerp e) (mod e gs-key-size))
        ((consp e)
         (let ((k (gs-key (caar e))))
           (dolist (x (cdr e) k) (setq k (mod (+ (* 31 k) (gs-key x)) gs-key-size)))))
        (t 0)))
;;; a pass that is off: every operation a new name (share), nothing depends on parameters alone
;;; (hoist)
(defun gs-find (tp e key)
  (if (gs-on '$share) (cdr (assoc e (gethash key (gs-table tp)) :test #'equal))))
(defun gs-keep (tp e key name) (push (cons e name) (gethash key (gs-table tp))) name)

;;; True if an expression holds parameters and numbers only. (What Maxima gets must be true or
;;; false: it takes any other list for an expression, and on GCL looks into it until it crashes.)
(defun $gs__constantp (tp e) (and (gs-constant-p (gs-nature tp) e) t))
(defun gs-constant-p (nature e)
  (cond ((symbolp e)
         (or (and (eq (gethash e nature) '$constant) (gs-on '$hoist)) ($constantp e)))
        ((atom e) t)
        ((eq (caar e) 'rat) t)
        (t (dolist (x (cdr e) t) (unless (gs-constant-p nature x) (return nil))))))

;;; the symbols of an expression or a list that are no constants of Maxima, each once
(defun $gs__symbols (e)
  (let ((l nil) (seen (if (and (consp e) (eq (caar e) 'mlist)) (make-hash-table :test #'eq))))
    (gs-rec ((walk (e)
               (cond ((consp e) (mapc #'walk (cdr e)))
                     ((or (not (symbolp e))
                          (if seen (gethash e seen) (member e l :test #'eq))
                          ($constantp e))
                      nil)
                     (t (when seen (setf (gethash e seen) t)) (push e l)))))
      (walk e)
      (gs-list (nreverse l)))))

;;; ------------------------------------------------------------------------------------------ signs

;;; true if the first term of e is negative: then e = -1*(something that starts positive)
(defun $gs__starts_negative (e)
  (cond ((atom e) (and (numberp e) (minusp e)))
        ((mnump e) (minusp (cadr e)))
        ((eq (caar e) 'mtimes) (and (mnump (cadr e)) ($gs__starts_negative (cadr e))))
        ((eq (caar e) 'mplus) ($gs__starts_negative (cadr e)))))
(defun $gs__negate (e)
  (if (gs-sum-p e) (addn (mapcar #'gs-minus (cdr e)) t) (gs-minus e)))

;;; ------------------------------------------------------------------------------------------ names

;;; The name of an expression on the tape tp; hint: text for it, or (text . text).
(defun $gs__tape_name (tp e hint)
  (cond ((gs-name-or-number-p e) e)
        (($gs__starts_negative e)
         (gs-minus ($gs__tape_name tp ($gs__negate e) (gs-negative-hint hint))))
        ((gs-constant-p (gs-nature tp) e)
         ($gs__tape_entry tp ($gs__unmarked e) "" '$constant))
        ((gs-sum-p e) (gs-tape-sum tp (cdr e) hint))
        ((gs-product-p e) (gs-tape-product tp (cdr e) hint))
        (t ($gs__tape_entry
             tp
             (simplifya
               (cons (list (caar e)) (mapcar #'(lambda (x) ($gs__tape_name tp x "")) (cdr e))) t)
             hint '$variable))))

;;; the hint of what is named in place of its negative: tau2 becomes neg_tau2, and back
(defun gs-negative-hint (hint)
  (let ((text (if (consp hint) (concatenate 'string (car hint) (cdr hint)) hint)))
    (cond ((string= text "") "")
          ((eql (search "neg_" text) 0) (subseq text 4))
          (t (concatenate 'string "neg_" text)))))

;;; the name of an operation on names
(defun $gs__tape_entry (tp e hint nature)
  (cond ((gs-name-or-number-p e) e)
        (($gs__starts_negative e)
         (gs-minus ($gs__tape_entry tp ($gs__negate e) (gs-negative-hint hint) nature)))
        (t (let ((key (gs-key e)))
             (or (gs-find tp e key)
                 (let ((v ($gs__tape_symbol tp (if (eq nature '$constant) "k" hint))))
                   (setf (gethash v (gs-nature tp)) nature)
                   ($gs__tape_write tp v e)
                   (gs-keep tp e key v)))))))

(defun $gs__tape_write (tp v e)
  (gs-tick)
  (incf (gs-count tp))
  (setf (gethash v (gs-entries tp))
        (gs-list (list v e (gs-block tp) (gs-count tp) ($gs__symbols e)))))
(defun gs-text-entry (s table key test) (assoc s (gethash key table) :test test))
(defun gs-use-text (tp s key) (push (list s) (gethash key (gs-used tp))))
(defun $gs__use_texts (tp texts)
  (dolist (s (cdr texts)) (gs-use-text tp s (gs-text-key s))))

;;; a new symbol: the hint itself if it is free, else the hint with a number; no hint is z, and z
;;; and k always have a number
(defun $gs__tape_symbol (tp hint)
  (let* ((stem (if (consp hint)
                   (concatenate 'string (car hint) (cdr hint))
                   (if (string= hint "") "z" hint)))
         (numbered (member stem '("z" "k") :test #'string=)) (numbers (gs-numbers tp))
         (place (gs-text-key stem))
         (last (or (gs-text-entry stem numbers place #'string=)
                   (car (push (cons stem (if numbered 1 0)) (gethash place numbers))))) text key)
    (loop
      (setq text (gs-numbered stem (cdr last) numbered) key (gs-text-key text))
      (incf (cdr last))
      (unless (gs-text-entry text (gs-used tp) key #'string-equal) (return)))
    (gs-use-text tp text key)
    (intern-invert-case (concatenate 'string "$" text))))
(defun gs-numbered (stem n numbered)
  (cond ((= n 0) stem)
        (numbered (format nil "~a~d" stem n))
        (t (format nil (if (digit-char-p (char stem (1- (length stem)))) "~a_~d" "~a~d") stem
                   (1+ n)))))

;;; --------------------------------------------------------------------------------------- products

;;; a product: its constants as one constant, its variables two by two, the sign in front
(defun gs-tape-product (tp factors hint)
  (let ((c 1) (x nil))
    (dolist (f factors)
      (if (gs-constant-p (gs-nature tp) f)
          (setq c (gs-times c f))
          (let ((g (gs-tape-factor tp f)))
            (when ($gs__starts_negative g) (setq c (gs-minus c) g (gs-minus g)))
            (push g x))))
    (let ((k ($gs__tape_name tp c "")))
      (gs-tape-times
        tp k (gs-tape-fold tp (nreverse x)
                           (case c (1 hint) (-1 (gs-negative-hint hint)) (t ""))) hint))))

;;; constant times name
(defun gs-tape-times (tp c v hint)
  (if (or (member c '(1 -1 0)) (eql v 1))
      (gs-times c v)
      ($gs__tape_entry tp (gs-times c v) hint '$variable)))

;;; x1*x2*x3 ... as ((x1*x2)*x3) ...
(defun gs-tape-fold (tp x hint)
  (let ((v (car x)))
    (do ((l (cdr x) (cdr l))) ((null l) v)
      (setq v ($gs__tape_entry tp (gs-times v (car l)) (if (cdr l) "" hint) '$variable)))))

;;; a factor: a name, or the name of a power of a name
(defun gs-tape-factor (tp f)
  (cond ((atom f) f)
        ((eq (caar f) 'mexpt)
         ($gs__tape_entry
           tp (power ($gs__tape_name tp (cadr f) "") ($gs__tape_name tp (caddr f) "")) ""
           '$variable))
        (t ($gs__tape_name tp f ""))))

;;; ------------------------------------------------------------------------------------------- sums

;;; a term as (values constant-factor variable-factor)
(defun gs-split-term (tp e)
  (let ((nature (gs-nature tp)))
    (cond ((gs-constant-p nature e) (values e 1))
          ((not (gs-product-p e)) (values 1 e))
          (t (let ((c nil) (x nil))
               (dolist (f (cdr e)) (if (gs-constant-p nature f) (push f c) (push f x)))
               (if c (values (gs-multiply c) (gs-multiply x)) (values 1 e)))))))

;;; a sum: terms with the same variable part are one term; the constants of a term are one constant
(defun gs-tape-sum (tp terms hint)
  (let ((parts nil))
    (dolist (e terms)
      (multiple-value-bind (c x) (gs-split-term tp e)
        (setq x ($gs__tape_name tp x ""))
        (when ($gs__starts_negative x) (setq x (gs-minus x) c (gs-minus c)))
        (let ((old (assoc x parts)))
          (if old (setf (cdr old) ($expand (gs-sum (cdr old) c))) (push (cons x c) parts)))))
    ($gs__tape_entry
      tp
      (gs-plus
        (mapcar #'(lambda (p) (gs-tape-times tp ($gs__tape_name tp (cdr p) "") (car p) ""))
                parts)) hint '$variable)))

;;; ------------------------------------------------------------------------------ vectors, matrices

(defun gs-hinted (hint more) (if (string= hint "") "" (cons hint more)))
(defun gs-name-one ; nm: the structure gs__namer(kind, rules, tape, registry)
(nm e hint)
  (cond ((atom e) e)
        ((eq (nth 1 nm) '$tape) ($gs__tape_name (nth 3 nm) e hint))
        (t (mfuncall '$gs__untaped_name nm e))))
(defun $gs__name (nm e hint) (gs-name-one nm e hint))
(defun $gs__name_vector (nm v hint)
  (gs-list
    (mapcar #'(lambda (e axis) (gs-name-one nm e (gs-hinted hint axis))) (cdr v)
            '("x" "y" "z"))))
(defun $gs__name_matrix (nm a hint)
  (let ((i 0) (j 0))
    (gs-list
      (mapcar #'(lambda (r)
                  (incf i)
                  (setq j 0)
                  (gs-list
                    (mapcar #'(lambda (e)
                                (incf j)
                                (gs-name-one nm e (gs-hinted hint (format nil "~d~d" i j))))
                            (cdr r)))) (cdr a)))))
(defun $gs__name_list (nm l)
  (gs-list (mapcar #'(lambda (e) (gs-name-one nm e "")) (cdr l))))

;;; a symmetric matrix, its upper half named
(defun $gs__symmetric (nm a hint)
  (let ((i 0) (upper nil) (rows nil))
    (dolist (r (cdr a))
      (let ((j i))
        (incf i)
        (push (mapcar #'(lambda (e)
                          (incf j)
                          (gs-name-one
                            nm e (gs-hinted hint (if (atom e) "" (format nil "~d~d" i j)))))
                      (nthcdr i r)) upper)))
    (setq upper (nreverse upper))
    (dotimes (k i (gs-list (nreverse rows)))
      (let ((row nil))
        (dotimes (l k) (push (nth (- k l) (nth l upper)) row))
        (push (gs-list (append (nreverse row) (nth k upper))) rows)))))

;;; The entries of M that the directions d and o of joints share (a mass matrix by rate), more by v,
;;; in place: see gs__directions. A direction is known by its kind and rates: without the pass
;;; `share` its vector has other names each time.
(defun $gs__add_to_matrix (m d o v)
  (let ((apart (not (and (alike1 (nth 1 d) (nth 1 o)) (alike1 (nth 3 d) (nth 3 o))))))
    (flet ((add (k l s)
             (let ((row (nth k m)))
               (setf (nth l row) (gs-plus (list (nth l row) (gs-times s v)))))))
      (dolist (a (cdr (nth 3 d)) m)
        (dolist (b (cdr (nth 3 o)))
          (destructuring-bind (k s) (cdr a)
            (destructuring-bind (l u) (cdr b)
              (add k l (gs-times s u))
              (when apart (add l k (gs-times s u))))))))))
