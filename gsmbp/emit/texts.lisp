;;; emit/texts.lisp: texts filled into lines.
(in-package :maxima)

;;; a text filled into lines of so many characters: `head` ahead of the first, `tail` ahead of the
;;; others
(defun $gs__filled (text head tail &optional (most 72))
  (let ((lines nil) (line (list head)) (width (length head)))
    (dolist (w (gs-split text)
               (gs-list
                 (nreverse (cons (string-right-trim " " (gs-joined (nreverse line) "")) lines))))
      (cond ((null (cdr line)) (push w line) (incf width (length w)))
            ((<= (+ width 1 (length w)) most)
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

