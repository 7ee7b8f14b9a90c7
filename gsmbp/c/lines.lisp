;;; c/lines.lisp: statements of C as lines, lists between commas, comments, the words of lines.
(in-package :maxima)

(declaim (special $gs__indent))

;;; a statement given in pieces as lines, indented by gs__indent
(defun $gs__c_statement (pieces)
  (gs-c-lines (gs-text (gs-joined (cdr pieces) "") ";") (gs-c-blanks)))
(defun gs-c-blanks () (make-string (+ 2 $gs__indent) :initial-element #\Space))
(defun $gs__c_text_lines (text) (gs-c-lines text (gs-c-blanks)))

;;; a text as lines of at most 98 characters, broken ahead of operators, if need be between tokens
(defun gs-c-lines (text indent)
  (let ((lines nil) (lead indent) (start 0) (size (length text)))
    (loop
      (let ((end (+ start (- 98 (length lead)))))
        (when (>= end size)
          (push (gs-text lead (subseq text start)) lines)
          (return (gs-list (nreverse lines))))
        (let ((cut (gs-c-break text start end)))
          (push (string-right-trim " " (gs-text lead (subseq text start cut))) lines)
          (setq start (if (char= (char text cut) #\Space) (1+ cut) cut)
                lead (gs-text indent "    ")))))))
;;; where the next line may begin: at most at end
(defun gs-c-break (text start end)
  (flet ((last-one (from test)
           (loop for k from end above from when (funcall test k) return k)))
    (or (last-one (+ start 40)
          #'(lambda (k) (and (char= (char text k) #\Space)
                             (find (char text (1+ k)) "+-&|")
                             (find (char text (+ k 2)) " &|"))))
        (last-one start
          #'(lambda (k) (or (and (char= (char text k) #\Space)
                                 (not (find (char text (1- k)) "+-=")))
                            (and (< k end) (find (char text k) "*/")))))
        end)))

;;; the factor "(x*x)" at the left end of a product needs no parentheses
(defun $gs__c_leading (text)
  (let ((last (1- (length text))))
    (if (and (char= (char text 0) #\() (eql (position #\) text) last)
             (every #'(lambda (c) (or (gs-word-character-p c) (char= c #\*)))
                    (subseq text 1 last)))
        (subseq text 1 last)
        text)))

;;; items between commas behind a head, as many on a line as it holds, below each other
(defun $gs__c_list (head items tail)
  (let ((lines nil) (line head) (blank (make-string (length head) :initial-element #\Space)))
    (do ((l (cdr items) (cdr l))) ((null l))
      (let ((piece (gs-text (car l) (if (cdr l) "," tail))))
        (cond ((string= line head) (setq line (gs-text line piece)))
              ((<= (+ (length line) 1 (length piece)) 98) (setq line (gs-text line " " piece)))
              (t (push line lines) (setq line (gs-text blank piece))))))
    (gs-list (nreverse (cons line lines)))))

;;; a comment of its own, filled, indented by gs__indent
(defun $gs__c_comment (text)
  (let ((lines (cdr ($gs__filled text (gs-text (gs-c-blanks) "/* ") (gs-text (gs-c-blanks) "   ")
                                 95))))
    (gs-list (append (butlast lines) (list (gs-text (car (last lines)) " */"))))))

;;; lines without those of comments, which have lines of their own
(defun gs-c-bare (lines)
  (let ((inside nil) (bare nil))
    (dolist (l lines (nreverse bare))
      (let ((begins (search "/*" l)))
        (cond ((and begins (not inside)) (push (subseq l 0 begins) bare) (setq inside t))
              ((not inside) (push l bare)))
        (when (search "*/" l) (setq inside nil))))))

;;; the words that lines hold outside of comments, as a table
(defun $gs__c_words (lines)
  (let ((words (make-hash-table :test #'equal)))
    (dolist (l (gs-c-bare (cdr lines)) words)
      (let ((start nil))
        (dotimes (k (1+ (length l)))
          (let ((in (and (< k (length l)) (gs-word-character-p (char l k)))))
            (cond ((and in (null start)) (setq start k))
                  ((and start (not in))
                   (setf (gethash (subseq l start k) words) t start nil)))))))))
