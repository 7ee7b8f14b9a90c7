;;; emit/order.lisp: the order of operands and of statements; sines and cosines in pairs.
(in-package :maxima)

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

;;; The code with [[sine, cosine], angle, block] in the place of the first of the entries under the
;;; heading trig that are the sine or cosine of an angle.
(defun $gs__sine_pairs (code)
  (let ((pairs nil) (kept nil))
    (dolist (c (cdr code) (gs-list (nreverse kept)))
      (destructuring-bind (s e heading) (cdr c)
        (if (not (and (eq heading '$trig) (consp e) (member (caar e) '(%sin %cos)))) (push c kept)
          (let ((p (assoc (cadr e) pairs :test #'alike1)))
            (unless p
              (push (setq p (cons (cadr e) (gs-list (list '$idle '$idle)))) pairs)
              (push (gs-list (list (cdr p) (cadr e) heading)) kept))
            (setf (nth (if (eq (caar e) '%sin) 1 2) (cdr p)) s)))))))

;;; the headings of the code, each once
(defun $gs__headings (code)
  (let ((l nil))
    (dolist (c (cdr code) (gs-list (nreverse l)))
      (pushnew (cadddr c) l :test #'equal))))

;;; the ways of the table [[words, way], ...] whose words one of the headings begins with
(defun $gs__ways_of_blocks (headings table)
  (let ((titles (remove-if-not #'stringp (cdr headings))))
    (gs-list (loop for (nil words way) in (cdr table)
                   when (some #'(lambda (title) (eql 0 (search words title))) titles)
                     collect way))))
