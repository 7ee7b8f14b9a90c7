;;; kernel/memory.lisp: what was made once for a scene is kept with it.
(in-package :maxima)

;;; A new, empty memory: a symbol that nothing else knows, with the table as a property, so that
;;; the two go when the scene goes. (The table itself in the scene would be printed and saved.)
(defun $gs__new_memo () (gensym "$GS__MEMO_"))
(defun gs-memory (scene)
  (let ((memo ($@-function scene '$memo)))
    (or (get memo 'gs-memory) (setf (get memo 'gs-memory) ($gs__new_hash)))))

;;; What a scene remembers under a key: [value], or false. With the key goes which passes are on:
;;; what was derived by others is not what is asked for.
(defun $gs__held (scene key) ($gs__held_always scene (gs-with-passes key)))
(defun $gs__hold (scene key value) ($gs__hold_always scene (gs-with-passes key) value))
(defun gs-with-passes (key) (gs-list (list key ($gs__passes_key))))
;;; whatever the passes are
(defun $gs__held_always (scene key) ($gs__get (gs-memory scene) key))
(defun $gs__hold_always (scene key value)
  ($gs__put (gs-memory scene) key (gs-list (list value)))
  value)

;;; The value of f() (a function of no arguments), computed when this scene is first asked for this
;;; key, then remembered.
(defun $gs__remember (scene key f)
  (let ((held ($gs__held scene key)))
    (if held (cadr held) ($gs__hold scene key (mapply1 f nil f (list f))))))

;;; A symbol that holds a value as long as somebody knows it, and what it holds, or false. Copies of
;;; a scene share it; it is printed and saved as a name alone.
(defun $gs__holder (value)
  (let ((holder (gensym "$GS__HOLDER_"))) (setf (get holder 'gs-value) value) holder))
(defun $gs__in_holder (holder) (get holder 'gs-value))
