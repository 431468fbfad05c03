package dev.eventchain.ocl;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * What the operations of libraries answered while an expression was evaluated. The reason why a
 * value is invalid is found by evaluating once more; operations of libraries may have effects, so
 * that they are not called again then, but give the same answers.
 */
final class LibraryCalls {

  private record Question(Object call, Object source, List<Object> arguments) {}

  /** An answer, or the exception that came instead. */
  private record Answer(Object value, RuntimeException failure) {
    Object give() {
      if (failure != null) {
        throw failure;
      }
      return value;
    }
  }

  private record Entry(Question question, Answer answer) {}

  private List<Entry> entries;
  private Map<Question, Deque<Answer>> answers;

  /** From now on, gives the answers of before to the questions of before. */
  void replay() {
    answers = new HashMap<>();
    if (entries != null) {
      for (Entry entry : entries) {
        answers.computeIfAbsent(entry.question(), q -> new ArrayDeque<>()).add(entry.answer());
      }
    }
  }

  /**
   * Calls an operation of a library.
   *
   * @param call identifies the call in its expression
   */
  Object call(
      Object call,
      OperationLibrary.Implementation implementation,
      Object source,
      List<Object> arguments,
      Evaluation run) {
    Question question = new Question(call, source, arguments);
    if (answers != null && answers.containsKey(question)) {
      Deque<Answer> known = answers.get(question);
      return (known.size() > 1 ? known.remove() : known.element()).give();
    }
    Answer answer;
    try {
      answer = new Answer(implementation.call(source, arguments, run), null);
    } catch (org.eclipse.ocl.EvaluationHaltedException e) {
      throw e;
    } catch (RuntimeException e) {
      answer = new Answer(null, e);
    }
    if (entries == null) {
      entries = new ArrayList<>();
    }
    entries.add(new Entry(question, answer));
    return answer.give();
  }
}
