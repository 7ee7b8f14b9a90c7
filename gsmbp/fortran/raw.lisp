;;; fortran/raw.lisp: the words of statements that are given as text.
(in-package :maxima)

(defun gs-word-char-p (c) (or (alphanumericp c) (char= c #\_)))

;;; the character of a text at a place, a blank behind its end
(declaim (inline gs-char-at))
(defun gs-char-at (s k) (if (< k (length s)) (char s k) #\Space))

;;; the first place from k on where the text has no character that `goes-on` takes
(defun gs-run-end (s k goes-on)
  (or (position-if-not goes-on s :start (min k (length s))) (length s)))

;;; one past the number that begins at k: 1, 1.5, .5D-3, but of 1.EQ.2 the 1 alone
(defun gs-number-end (s k)
  (flet ((at (e) (gs-char-at s e)))
    (loop while (or (digit-char-p (at k))
                    (and (char= (at k) #\.)
                         (or (not (alpha-char-p (at (1+ k))))
                             (and (find (at (1+ k)) "DE") (not (alpha-char-p (at (+ k 2))))))))
          do (incf k))
    (if (find (at k) "DE") (gs-run-end s (+ k 2) #'digit-char-p) k)))

;;; one past the token that begins at k with c
(defun gs-token-end (s k c)
  (cond ((alpha-char-p c) (gs-run-end s k #'gs-word-char-p))
        ((digit-char-p c) (gs-number-end s k))
        ((and (char= c #\*) (char= (gs-char-at s (1+ k)) #\*)) (+ k 2))
        ((char= c #\.) (1+ (or (position #\. s :start (1+ k)) (1- (length s)))))
        (t (1+ k))))

;;; gs__tokens(text): names, numbers, operators of a text of Fortran, in capitals
(defun $gs__tokens (text)
  (let ((s (string-upcase text)) (k 0) (tokens nil))
    (loop while (< k (length s))
          do (let* ((c (char s k)) (e (gs-token-end s k c)))
               (unless (char= c #\Space) (push (subseq s k e) tokens))
               (setq k e)))
    (gs-list (nreverse tokens))))

;;; gs__array_of("M(2,1)") => "M"
(defun $gs__array_of (place) (string-upcase (subseq place 0 (position #\( place))))
