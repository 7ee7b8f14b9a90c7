;;; emit/legend.lisp: what the constants of emit/legend.mac are made of: units, parameters,
;;; links and devices (ten to twenty times faster than in Maxima where there are thousands).
(in-package :maxima)

(defvar $gs__no_powers (gs-list (list 0 0 0 0 0)))
(defvar *gs-few-operations* 3) ; a constant of so few is written out in what is made of it

(defun gs-legend-table (legend field) ($@-function legend field))
(defun gs-legend-entry (legend s) (gethash s (gs-entries ($@-function legend '$tape))))

;;; ------------------------------------------------------------------------------------ parameters

;;; Notes where the symbols of an expression (or a list of them) stand: what ("mass"), of whom
;;; ("link2")
(defun $gs__note (legend what owner e)
  (if ($listp e)
      (dolist (x (cdr e)) ($gs__note legend what owner x))
      (dolist (s (cdr ($gs__symbols e)))
        (gs-note-symbol (gs-legend-table legend '$words) s owner
                        (if (or (eq e s) (alike1 e (gs-minus s)))
                            what
                            (gs-text "part of the " what)))))
  '$done)
(defun $gs__note_axes (legend what owner vector)
  (loop for e in (cdr vector) for axis in '("x" "y" "z")
        do ($gs__note legend (gs-text axis " of the " what) owner e))
  '$done)
;;; words: symbol -> [[text, [owner, ...]], ...]
(defun gs-note-symbol (words s owner text)
  (let* ((rows (cdr (gethash s words))) (old (find text rows :key #'cadr :test #'equal)))
    (flet ((row (owners) (gs-list (list text (gs-list owners)))))
      (cond ((null old)
             (setf (gethash s words) (gs-list (append rows (list (row (list owner)))))))
            ((not (member owner (cdr (caddr old)) :test #'equal))
             (setf (gethash s words)
                   (gs-list (substitute (row (append (cdr (caddr old)) (list owner))) old rows
                                        :test #'eq))))))))
(defun $gs__words_about (legend s) (gethash s (gs-legend-table legend '$words) (gs-list nil)))

;;; ------------------------------------------------------------------------------------------ units

;;; powers of kg, m, s, A, K of an expression of the tape; unknown where a unit is not known
(defun $gs__powers_of (legend e)
  (cond ((mnump e) $gs__no_powers)
        ((symbolp e) (gs-symbol-powers legend e))
        ((gs-sum-p e) ($gs__powers_of legend (cadr e)))
        ((gs-product-p e)
         (reduce #'gs-times-powers (mapcar #'(lambda (x) ($gs__powers_of legend x)) (cdr e))))
        ((and (gs-power-p e) (mnump (caddr e)))
         (gs-scaled-powers (caddr e) ($gs__powers_of legend (cadr e))))
        (t $gs__no_powers)))
(defun gs-times-powers (p q)
  (if (or (eq p '$unknown) (eq q '$unknown)) '$unknown (gs-list (mapcar #'add (cdr p) (cdr q)))))
(defun gs-scaled-powers (n p)
  (if (eq p '$unknown) p (gs-list (mapcar #'(lambda (k) (mul n k)) (cdr p)))))
(defun gs-symbol-powers (legend s)
  (let ((powers (gs-legend-table legend '$powers)) (entry (gs-legend-entry legend s)))
    (or (gethash s powers)
        (setf (gethash s powers)
              (cond (entry ($gs__powers_of legend (gs-entry-expression entry)))
                    (($constantp s) $gs__no_powers)
                    (t '$unknown))))))

;;; ----------------------------------------------------------------------------- what it is made of

;;; the parameters that a symbol is made of, in Maxima's order
(defun $gs__leaves_of (legend s)
  (let ((leaves (gs-legend-table legend '$leaves)) (entry (gs-legend-entry legend s)))
    (or (gethash s leaves)
        (setf (gethash s leaves)
              (gs-list
                (if entry
                    (reduce #'gs-merged
                            (mapcar #'(lambda (x) (cdr ($gs__leaves_of legend x)))
                                    (gs-entry-symbols entry))
                            :initial-value nil)
                    (list s)))))))
;;; two lists of symbols in Maxima's order as one, each symbol once
(defun gs-merged (a b)
  (let ((l nil))
    (loop
      (cond ((null a) (return (nreconc l b)))
            ((null b) (return (nreconc l a)))
            ((eq (car a) (car b)) (pop a))
            ((great (car b) (car a)) (push (pop a) l))
            (t (push (pop b) l))))))

;;; the expression of a constant in parameters, as far as those in it are short
(defun $gs__expanded_of (legend s)
  (let ((expanded (gs-legend-table legend '$expanded)))
    (or (gethash s expanded)
        (let ((h ($gs__new_hash)) (entry (gs-legend-entry legend s)))
          (dolist (x (gs-entry-symbols entry))
            (when (and (gs-legend-entry legend x) (gs-brief-p ($gs__expanded_of legend x)))
              (setf (gethash x h) ($gs__expanded_of legend x))))
          (setf (gethash s expanded) ($gs__replace h (gs-entry-expression entry)))))))
(defun gs-brief-p (e) (<= ($gs__operations e) *gs-few-operations*))

;;; ---------------------------------------------------------------------------------------- owners

;;; gs__owners_by_mass(leaves, heavy, owners): the owners of those parameters that are in the table
;;; heavy; what several have in common counts as that of those which own the rest of the constant
;;; too, where there are such. Without such parameters: the owners of all.
(defun $gs__owners_by_mass (leaves heavy owners)
  (gs-rec ((heavy-p (x) (gethash x heavy))
           (owned (symbols) (loop for x in symbols append (cdr (gethash x owners)))))
    (let ((masses (remove-if-not #'heavy-p (cdr leaves)))
          (others (owned (remove-if #'heavy-p (cdr leaves)))))
      (gs-rec ((shared-p (owner) (member owner others :test #'equal))
               (narrowed (own) (or (and (cdr own) (remove-if-not #'shared-p own)) own)))
        (gs-list
          (gs-first-seen
            (if masses (loop for x in masses append (narrowed (owned (list x)))) others)))))))

;;; ------------------------------------------------------------------------------------------ words

;;; what an entry says of a parameter, up to the first clause
(defun $gs__first_clause (text)
  (string-trim " " (subseq text 0 (position-if #'(lambda (c) (find c ",;(:")) text))))

;;; "mass of link1, link2"; of more than four the first and the last
(defun $gs__of_owners (what owners)
  (let ((names (mapcar #'$sconcat (remove "" (cdr owners) :test #'equal))))
    (cond ((null names) what)
          ((> (length names) 4)
           (gs-text what " of " (car names) ", ..., " (car (last names))))
          (t (gs-text what " of " (gs-joined names ", "))))))
;;; what a parameter is: where it stands alone ahead, three places at most
(defun $gs__words_joined (words)
  (flet ((part-p (row) (eql 0 (search "part of" (cadr row))))
         (text-of (row) ($gs__of_owners (cadr row) (caddr row))))
    (let ((texts (mapcar #'text-of
                         (append (remove-if #'part-p (cdr words))
                                 (remove-if-not #'part-p (cdr words))))))
      (gs-joined (if (cdddr texts) (append (subseq texts 0 3) (list "...")) texts) "; "))))
