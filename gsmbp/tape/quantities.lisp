;;; tape/quantities.lisp: scalars, vectors, matrices of the mechanics that name themselves. The
;;; namer (tape/namer.mac) is bound once for a stage, gs__naming; the hint, the quantity's letters,
;;; is required: F : gs__named("f", gs__cross(e, h)).
(in-package :maxima)

(defvar $gs__naming)                     ; the namer of a stage; unbound outside
(defun gs-naming ()
  (if (boundp '$gs__naming)
      (symbol-value '$gs__naming)
      (mfuncall '$gs__error "model" "a quantity is named outside of a stage that has a namer")))

;;; Quantities whose symbols on the tape begin with their letters, as those with a number do (w3):
;;; the others have numbers, z1, z2, ... Symbols decide which of equal choices the passes take
;;; (tape/factor.lisp).
(defvar *gs-lettered* '("ee" "ww" "len" "touch" "kinetic" "potential" "phic" "gam" "m"))
(defun gs-stem (hint)
  (if (or (some #'digit-char-p hint) (member hint *gs-lettered* :test #'string=)) hint ""))

;;; ---------------------------------------------------------------------------------------- labels

;;; What a name on the tape is called in a routine, (hint subject index), kept under its symbol: the
;;; first label stays. subject: what the block is about (gs__of_link), nil of a matrix or list by
;;; rates. Parameters' constants have places in CST instead.
(defmacro gs-subject (tp) `(nth 9 ,tp))
(defmacro gs-labels (tp) `(nth 10 ,tp))
(defun gs-symbol-of (name)   ; s of s and -s, or nil
  (cond ((symbolp name) name)
        ((and (consp name) (eq (caar name) 'mtimes) (eql (cadr name) -1) (null (cdddr name))
              (symbolp (caddr name)))
         (caddr name))))
(defun gs-marked (nm name hint index)
  (when (eq (nth 1 nm) '$tape)
    (let ((tp (nth 3 nm)))
      (gs-put-label tp name (list (if (symbolp name) hint (gs-negative-hint hint))
                                  (if (consp index) nil (gs-subject tp))
                                  index))))
  name)
(defun gs-put-label (tp name label)
  (let ((s (gs-symbol-of name)))
    (when (and s (not (gethash s (gs-labels tp))) (gethash s (gs-entries tp))
               (not (gethash s (nth 6 tp))) (not (eq (gethash s (gs-nature tp)) '$constant)))
      (setf (gethash s (gs-labels tp)) label))))
;;; The derivative of a name that has a label, not as a derivative: its label is made of that of the
;;; name and of what moves: the symbol of the only seed, or time.
(defun gs-mark-rate (tp rate name seeds)
  (let ((label (gethash name (gs-labels tp))))
    (when (and label (not (eq (third label) 'rate)))
      (gs-put-label tp rate (list name (if (cdr seeds) '$t (cadr (car seeds))) 'rate)))))

;;; the text of a label: w3 and "x" is w3x; j, of link 2, and "12" is j2_12; mm and (1 2) is mm12;
;;; nil if there is none, or a long one
(defun gs-label-text (tp s)
  (let ((label (gethash s (gs-labels tp))))
    (cond
      ((null label) nil)
      ((eq (third label) 'rate)
       (let ((text (gs-label-text tp (first label))))
         (and text (<= (length text) 8)
              (string-downcase (gs-text "d" text "_" (gs-shown-name (second label)))))))
      (t (destructuring-bind (hint subject index) label
        (let* ((stem (if (or (null subject) (some #'digit-char-p hint))
                         hint
                         ($sconcat hint subject)))
               (tail (gs-index-text index))
               (text (if (and (string/= tail "") (digit-char-p (char tail 0))
                              (digit-char-p (char stem (1- (length stem)))))
                         (gs-text stem "_" tail)
                         (gs-text stem tail))))
          (and (<= (length text) 20) (string-downcase text))))))))
;;; a symbol as Maxima prints it
(defun gs-shown-name (s)
  (let ((text (symbol-name s)))
    (if (and (char= (char text 0) #\$)
             (do ((i 1 (1+ i))) ((= i (length text)) t)
               (unless (gs-word-character-p (char text i)) (return nil))))
        (maybe-invert-string-case (subseq text 1))
        (coerce (mstring s) 'string))))
(defun gs-index-text (index)
  (cond ((null index) "")
        ((stringp index) index)
        (t (format nil (if (some #'(lambda (k) (> k 9)) index) "~{~d~^_~}" "~{~d~}") index))))

;;; those of the symbols that have neither a label nor a number for a name are taken
(defun $gs__take_unlabelled (tp taken symbols)
  (dolist (s (cdr symbols))
    (unless (or (gs-numbered-z-p s) (gs-label-text tp s)) (setf (gethash s taken) t))))
;;; z1, z2, ... as far as they are not taken, for those of the symbols that have a number for a name
;;; and nothing in the table
(defun $gs__put_numbers (table taken symbols)
  (let ((k 0) (z nil))
    (dolist (s (cdr symbols) table)
      (when (and (gs-numbered-z-p s) (not (gethash s table)))
        (loop (setq z (gs-symbol-named (format nil "z~d" (incf k))))
              (unless (gethash z taken) (return)))
        (setf (gethash s table) z)))))
;;; Symbols for the temporaries of a routine, code its entries [name, expression, ...]: those of
;;; their labels where they have any (a second of the same label has _2 behind it), else of what
;;; they are. taken: table of the symbols that are in use.
(defun $gs__put_labels (tp table taken code)
  (dolist (e (cdr code))
    (let ((text (gs-label-text tp (cadr e))))
      (when text (setf (gethash (cadr e) table) ($gs__free_symbol taken text)))))
  (dolist (e (cdr code)) (gs-label-half tp table taken (cadr e) (caddr e)))
  (dolist (e (cdr code) table) (gs-label-product tp table taken (cadr e) (caddr e))))
;;; a temporary of which s is a half
(defun gs-label-half (tp table taken s e)
  (when (and (gethash s table) (gs-product-p e) (alike1 (cadr e) '((rat simp) 1 2))
             (symbolp (caddr e)) (null (cdddr e)) (gs-numbered-p tp table (caddr e)))
    (setf (gethash (caddr e) table)
          ($gs__free_symbol taken (gs-text (gs-shown-name (gethash s table)) "x2")))))
;;; a symbol without the gs__ of those that are not the user's
(defun gs-public-name (s)
  (let ((text (gs-shown-name s)))
    (if (eql 0 (search "gs__" text)) (subseq text 4) text)))
;;; cq2*cq3 is cq2cq3, cq2^2 is cq2cq2
(defun gs-label-product (tp table taken s e)
  (let ((factors (cond ((atom e) nil)
                       ((gs-product-p e) (cdr e))
                       ((and (gs-power-p e) (eql (caddr e) 2)) (list (cadr e) (cadr e))))))
    (when (and factors (null (cddr factors)) (every #'symbolp factors)
               (gs-numbered-p tp table s)
               (notany #'(lambda (x) (gs-numbered-p tp table x)) factors))
      (let* ((names (mapcar #'(lambda (x) (gethash x table x)) factors))
             ;; a constant that is compiled in is a number by now
             (text (and (every #'symbolp names)
                        (format nil "~{~a~}" (mapcar #'gs-public-name names)))))
        (when (and text (<= (length text) 12))
          (setf (gethash s table) ($gs__free_symbol taken (string-downcase text))))))))
;;; a temporary z1, z2, ... without a name of its own
(defun gs-numbered-p (tp table s)
  (and (gethash s (gs-nature tp)) (not (gethash s table)) (gs-numbered-z-p s)))
(defun gs-numbered-z-p (s)            ; is its name z and a number
  (let* ((text (symbol-name s)) (n (length text)))
    (and (> n 2) (string= "$Z" text :end2 2)
         (do ((i 2 (1+ i))) ((= i n) t) (unless (digit-char-p (char text i)) (return nil))))))
;;; a symbol that is not taken: text, or text_2, ...; taken: under a text its last number
(defun $gs__free_symbol (taken text)
  (do* ((k (gethash text taken 1) (1+ k)) (s (gs-symbol-tried text k) (gs-symbol-tried text k)))
      ((not (gethash s taken)) (setf (gethash s taken) t (gethash text taken) k) s)))
(defun gs-symbol-tried (text k)
  (gs-symbol-named (if (= k 1) text (format nil "~a_~d" text k))))
(defun gs-symbol-named (text) (intern-invert-case (concatenate 'string "$" text)))

;;; ------------------------------------------------------------------------------------ quantities

(defun gs-name-marked (nm e hint index)
  (gs-marked nm
             (gs-name-one nm e
                          (gs-hinted (gs-stem hint)
                                     (if (consp index) (format nil "~{~d~}" index) index)))
             hint index))

;;; The name of a quantity: a scalar, a 3-vector, or a matrix (rows). index: of a scalar which of
;;; several it is, text of axes, or a list of the numbers of rates; of a matrix `rates`, if its rows
;;; are.
(defun $gs__named (hint e &optional index)
  (let ((nm (gs-naming)))
    (cond ((not ($listp e))
           (gs-marked nm (gs-name-one nm e (gs-stem hint)) hint
                      (if ($listp index) (cdr index) index)))
          ((and (cdr e) ($listp (cadr e))) (gs-named-matrix nm hint e index))
          (t (gs-list
               (mapcar #'(lambda (x axis) (gs-name-marked nm x hint axis)) (cdr e)
                       '("x" "y" "z")))))))

(defun gs-entry-index (i j index) (if index (list i j) (format nil "~d~d" i j)))
(defun gs-named-matrix (nm hint a index)
  (gs-list
    (loop for r in (cdr a) for i from 1
          collect (gs-list
                    (loop for e in (cdr r) for j from 1
                          collect (if (atom e)
                                      e
                                      (gs-name-marked nm e hint (gs-entry-index i j index))))))))

;;; a symmetric matrix, its upper half named
(defun $gs__named_symmetric (hint a &optional index)
  (let* ((nm (gs-naming)) (n (length (cdr a))) (rows (make-array (list n n))))
    (loop for r in (cdr a) for i from 0
          do (loop for e in (nthcdr (1+ i) r) for j from i
                   do (setf (aref rows i j)
                            (if (atom e)
                                e
                                (gs-name-marked nm e hint
                                                (gs-entry-index (1+ i) (1+ j) index))))))
    (gs-list
      (loop for i below n
            collect (gs-list (loop for j below n collect (aref rows (min i j) (max i j))))))))

;;; a list of scalars, told apart by their numbers in it
(defun $gs__named_list (hint l)
  (let ((nm (gs-naming)) (k 0))
    (gs-list
      (mapcar #'(lambda (e) (incf k) (gs-marked nm (gs-name-one nm e "") hint (list k)))
              (cdr l)))))

;;; The entries of M that a column, the wrench [f, n] of the direction d, has with the screws
;;; [direction, factor of f, factor of n], in place
(defun $gs__add_screw_entries (m d screws f n)
  (let ((column (append (cdr f) (cdr n))))
    (dolist (o (cdr screws) m)
      (destructuring-bind (direction a b) (cdr o)
        ($gs__add_to_matrix
          m d direction
          ($gs__named "mm" (gs-inner (append (cdr a) (cdr b)) column)
                      (gs-list (list (gs-rate-number d) (gs-rate-number direction)))))))))
;;; of the structure gs__direction(kind, axis, moves): the number of its first rate
(defun gs-rate-number (d) (cadr (cadr (nth 3 d))))

;;; -------------------------------------------------------------------------------------- headings

;;; A heading for the entries that follow (a comment line in the Fortran); what it is about; of the
;;; namer gs__naming, what is said of link i (or joint, or rate i)
(defun $gs__block (nm text) ($gs__block_about nm text ""))
(defun $gs__block_about (nm text subject)
  (when (eq (nth 1 nm) '$tape)
    (let ((tp (nth 3 nm))) (setf (gs-block tp) text (gs-subject tp) subject)))
  '$done)
(defun $gs__of_link (text i &rest more)
  ($gs__block_about (gs-naming) (apply #'$sconcat text i more) i))
