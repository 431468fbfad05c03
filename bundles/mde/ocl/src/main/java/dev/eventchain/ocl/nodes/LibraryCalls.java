package dev.eventchain.ocl.nodes;

import dev.eventchain.ocl.dialect.OperationLibrary;
import dev.eventchain.ocl.values.Halted;
import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/**
 * The recorded results of library operations during an evaluation. To explain an invalid value, the
 * expression is evaluated again; since library operations may have effects, their results are then
 * replayed.
 */
public final class LibraryCalls {

  private record Question(Object call, Object source, List<Object> arguments) {}

  /** A result, or the exception thrown instead. */
  private record Answer(Object value, RuntimeException failure) {
    Object give() {
      if (failure != null) {
        throw failure;
      }
      return value;
    }
  }

  private static final int PARTS = 4;

  /** Call, source, arguments and result of each call in sequence; exceptions are wrapped. */
  private Object[] entries = new Object[2 * PARTS];

  private int size;
  private Map<Question, Deque<Answer>> answers;

  /** Starts replaying the recorded results. */
  void replay() {
    answers = new HashMap<>();
    for (int i = 0; i < size; i += PARTS) {
      Question question =
          new Question(entries[i], entries[i + 1], Arrays.asList((Object[]) entries[i + 2]));
      Object value = entries[i + 3];
      Answer answer = value instanceof Answer failed ? failed : new Answer(value, null);
      answers.computeIfAbsent(question, q -> new ArrayDeque<>()).add(answer);
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
      Object[] arguments,
      Run run) {
    Deque<Answer> known =
        answers == null ? null : answers.get(new Question(call, source, Arrays.asList(arguments)));
    if (known != null) {
      return (known.size() > 1 ? known.remove() : known.element()).give();
    }
    try {
      Object value = implementation.call(source, Arrays.asList(arguments), run);
      add(call, source, arguments, value);
      return value;
    } catch (Halted e) {
      throw e;
    } catch (RuntimeException e) {
      add(call, source, arguments, new Answer(null, e));
      throw e;
    }
  }

  private void add(Object call, Object source, Object[] arguments, Object answer) {
    if (size == entries.length) {
      entries = Arrays.copyOf(entries, size * 2);
    }
    entries[size] = call;
    entries[size + 1] = source;
    entries[size + 2] = arguments;
    entries[size + 3] = answer;
    size += PARTS;
  }
}
