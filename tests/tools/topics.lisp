;;; topic_opens(name): whether describe of Maxima finds a text of GSMBP's manual for the name that
;;; tells of it, and more than its heading. (describe itself asks which one is meant where Maxima
;;; has such a topic, too.)
(in-package :maxima)

(defun $topic_opens (name)
  (some #'(lambda (text) (and (topic-has-text text) (search name text :test #'char-equal) t))
        (topic-texts name)))

;;; node_opens(name): whether describe finds the text of a node: its heading, a line under the
;;; heading, and more.
(defun $node_opens (name)
  (some #'(lambda (text) (and (search name text) (< 2 (length (topic-lines text))) t))
        (topic-texts name)))

(defun topic-texts (name)
  (loop for (folder . matches) in (cl-info::exact-topic-match name)
        when (search "share/manual" (namestring folder))
        append (mapcar #'(lambda (match) (cl-info::read-info-text folder match)) (car matches))))
;;; Return the lines of a text that are not blank.
(defun topic-lines (text)
  (with-input-from-string (in text)
    (loop for line = (read-line in nil) while line
          unless (string= "" (string-trim " " line)) collect line)))

;;; Return whether a text begins with a heading (" -- ", continued on lines indented by ten blanks)
;;; and has a line after the headings.
(defun topic-has-text (text)
  (flet ((begins (line word) (eql 0 (search word line))))
    (let ((lines (topic-lines text)))
      (and (begins (car lines) " -- ")
           (find-if-not #'(lambda (line) (or (begins line " -- ") (begins line "          ")))
                        lines)
           t))))
