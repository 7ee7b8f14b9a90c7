;;; routines/split.lisp: long straight-line code in parts (see routines/split.mac): where it is cut,
;;; and what crosses the cuts.
(in-package :maxima)

;;; what an entry [symbol, expression, block] of the code sets: a symbol, or the two of a pair
(defun gs-set-by (entry)
  (let ((s (cadr entry))) (if (consp s) (remove '$idle (cdr s)) (list s))))

;;; true if the code is assignments to symbols only
(defun $gs__is_straight (code)
  (loop for c in (cdr code) always (or ($listp (cadr c)) (and (cadr c) (symbolp (cadr c))))))

;;; The code [symbol, expression, block] and the results [place, expression] cut into parts of at
;;; most `size` assignments: [words, [code, results, loads], ...]. What a later part needs is a
;;; result of the part that finds it and a load [symbol, place] of the other: in the place of a
;;; result where it is one, else in WRK(1 ... words).
(defun $gs__cut_code (code results size)
  (let* ((code (coerce (cdr code) 'simple-vector)) (n (length code))
         (found (make-hash-table :test #'eq)) (last (make-hash-table :test #'eq))
         (due (make-array n :initial-element nil)))
    (dotimes (i n) (dolist (s (gs-set-by (svref code i))) (setf (gethash s found) i)))
    (flet ((needs (e i)
             (dolist (s (cdr ($gs__symbols e)))
               (when (gethash s found) (setf (gethash s last) (max i (gethash s last 0)))))))
      (dotimes (i n) (needs (caddr (svref code i)) i))
      (dolist (r (cdr results))
        (let ((i 0))
          (dolist (s (cdr ($gs__symbols (caddr r)))) (setq i (max i (gethash s found 0))))
          (needs (caddr r) i)
          (push r (svref due i)))))
    (gs-parts code due found last (gs-cuts due (gs-crossing n found last) size))))

;;; how many symbols cross between the entries i and i + 1, by i
(defun gs-crossing (n found last)
  (let ((live (make-array (1+ n) :initial-element 0)) (sum 0))
    (maphash
      #'(lambda (s i)
          (let ((j (gethash s last i))) (when (> j i) (incf (svref live i)) (decf (svref live j)))))
      found)
    (dotimes (i n live) (setf (svref live i) (incf sum (svref live i))))))

;;; For every entry the number of its part. A cut lies where least crosses between six tenths of a
;;; part and a whole one.
(defun gs-cuts (due live size)
  (let* ((n (length due)) (part (make-array n)) (weight (make-array (1+ n) :initial-element 0))
         (from 0) (k 0))
    (dotimes (i n) (setf (svref weight (1+ i)) (+ (svref weight i) 1 (length (svref due i)))))
    (flet ((upto (i) (- (svref weight (1+ i)) (svref weight from))))
      (loop
        (let ((best nil))
          (if (<= (upto (1- n)) size)
              (setq best (1- n))
              (do ((i from (1+ i)))
                  ((or (= i (1- n)) (and best (> (upto i) size))))
                (when (and (>= (upto i) (* 6/10 size))
                           (or (null best) (< (svref live i) (svref live best))))
                  (setq best i))))
          (do ((i from (1+ i))) ((> i best)) (setf (svref part i) k))
          (setq from (1+ best) k (1+ k))
          (when (= from n) (return part)))))))

;;; the parts themselves
(defun gs-parts (code due found last part)
  (let* ((n (length code)) (count (1+ (svref part (1- n)))) (words 0)
         (place (make-hash-table :test #'eq)) (loaded (make-hash-table :test #'eq))
         (codes (make-array count :initial-element nil))
         (results (make-array count :initial-element nil))
         (loads (make-array count :initial-element nil)))
    (flet ((crosses (s)
             (let ((i (gethash s found)))
               (and i (< (svref part i) (svref part (gethash s last i))))))
           (load-into (k symbols)
             (dolist (s symbols)
               (let ((i (gethash s found)))
                 (when (and i (< (svref part i) k) (not (eql (gethash s loaded) k)))
                   (setf (gethash s loaded) k)
                   (push (gs-list (list s (gethash s place))) (svref loads k)))))))
      (dotimes (i n)
        (let ((k (svref part i)))
          (push (svref code i) (svref codes k))
          (load-into k (cdr ($gs__symbols (caddr (svref code i)))))
          (dolist (r (reverse (svref due i)))
            (let ((e (caddr r)))
              (push r (svref results k))
              (load-into k (cdr ($gs__symbols e)))
              (when (and (symbolp e)
                         (crosses e)
                         (not (gethash e place))
                         (= k (svref part (gethash e found))))
                (setf (gethash e place) (cadr r)))))
          (dolist (s (gs-set-by (svref code i)))
            (when (and (crosses s) (not (gethash s place)))
              (setf (gethash s place) (gs-place "WRK" (incf words)))
              (push (gs-list (list (gethash s place) s)) (svref results k)))))))
    (gs-list
      (cons words
            (loop
              for
              k
              below
              count
              collect
              (gs-list
                (mapcar #'(lambda (l) (gs-list (reverse (svref l k))))
                        (list codes results loads))))))))
