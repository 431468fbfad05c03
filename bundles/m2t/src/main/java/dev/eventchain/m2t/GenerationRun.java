package dev.eventchain.m2t;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.m2t.syntax.Place;
import dev.eventchain.ocl.Evaluation;
import dev.eventchain.ocl.Expression;
import dev.eventchain.ocl.Invalid;
import dev.eventchain.ocl.OperationLibrary;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.Collections;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import org.eclipse.emf.ecore.EObject;

/** The state of one generation: variables, output, the stack of calls, findings. One thread. */
final class GenerationRun {
  /** Deep enough for a template that follows a chain of some hundred elements. */
  static final int DEEPEST_CALL = 500;

  private static final int CALLS_SHOWN = 8;

  /** More than that come from the model, and from there any number can come. */
  private static final int MOST_PATTERNS = 256;

  /** A call, and the expression it was made by; null for the first. */
  private record Frame(Callable callable, List<Object> arguments, Expression caller) {}

  /** Generation cannot go on; the reason has been reported. */
  static final class StoppedException extends RuntimeException {
    private static final long serialVersionUID = 1L;

    StoppedException() {
      super("generation was stopped", null, false, false);
    }
  }

  private final Evaluation evaluation;
  private final GenerationContext context;
  private final Findings findings;
  private final GeneratedFiles files;
  private final ObjectQueries objects;
  private final Deque<Frame> frames = new ArrayDeque<>();
  private Object[] selves = new Object[32];
  private int selfCount;
  private final Map<Query, Map<Object, Object>> cache = new HashMap<>();
  private final Map<String, TokenWalk> tokenWalks = new HashMap<>();
  private final Map<String, Pattern> patterns = new HashMap<>();
  private final Map<Class<?>, Object> serviceInstances = new HashMap<>();
  private final OutputBuffer output;
  private final Tracing tracing;
  private Expression current;
  private boolean stopped;
  private final boolean modelChanges;

  GenerationRun(
      Collection<? extends EObject> roots, GenerationContext context, boolean modelChanges) {
    this.modelChanges = modelChanges;
    this.evaluation = Evaluation.over(roots).attach(this);
    this.context = context;
    this.tracing = context.traced() ? new Tracing(context.locator()) : null;
    this.output = new OutputBuffer(context.traced());
    this.findings = new Findings();
    this.files = new GeneratedFiles(this, context.earlier());
    this.objects = new ObjectQueries(evaluation);
  }

  Evaluation evaluation() {
    return evaluation;
  }

  GeneratedFiles files() {
    return files;
  }

  ObjectQueries objects() {
    return objects;
  }

  Optional<String> property(String key) {
    return context.property(key);
  }

  Optional<String> property(String file, String key) {
    return context.property(file, key);
  }

  /** The walk through the tokens of a text that {@code strtok} goes on with. */
  TokenWalk tokenWalk(String text, boolean restart) {
    if (restart) {
      tokenWalks.remove(text);
    }
    return tokenWalks.computeIfAbsent(text, TokenWalk::new);
  }

  /** A regular expression, which is dear to compile. */
  Pattern pattern(String expression) {
    Pattern known = patterns.get(expression);
    if (known == null) {
      known = Pattern.compile(expression);
      if (patterns.size() >= MOST_PATTERNS) {
        patterns.clear();
      }
      patterns.put(expression, known);
    }
    return known;
  }

  /** The instances of Java services whose methods are not static: one of each class. */
  Map<Class<?>, Object> serviceInstances() {
    return serviceInstances;
  }

  GenerationResult result() {
    GenerationTrace trace = tracing == null ? GenerationTrace.NONE : tracing.result();
    return new GenerationResult(files.contents(), findings.all(), trace);
  }

  /** Where the lines of files are noted; nowhere (null) if nobody wants to know. */
  Tracing tracing() {
    return tracing;
  }

  // --- evaluation

  /** The value of an expression; an invalid one has been reported. */
  Object evaluate(Expression expression) {
    return evaluate(expression, null, false);
  }

  /** {@link Expression#read}; where Java services may change the model, {@link #evaluate}. */
  Object read(Expression expression) {
    return evaluate(expression, null, !modelChanges);
  }

  /** {@link Expression#evaluateCalls}; an invalid value has been reported. */
  Object evaluateCalls(Expression expression, OperationLibrary.Implementation receiver) {
    return evaluate(expression, receiver, false);
  }

  private Object evaluate(
      Expression expression, OperationLibrary.Implementation receiver, boolean read) {
    Expression outer = current;
    current = expression;
    try {
      Object value;
      if (receiver != null) {
        value = expression.evaluateCalls(evaluation, receiver);
      } else {
        value = read ? expression.read(evaluation) : expression.evaluate(evaluation);
      }
      if (value instanceof Invalid invalid) {
        if (stopped) {
          throw new StoppedException();
        }
        if (invalid.limit()) {
          throw stop(invalid.reason(), invalid.location());
        }
        undefined(expression, invalid);
      }
      return value;
    } finally {
      current = outer;
    }
  }

  /** Where the expression at work stands. */
  SourceLocation place() {
    return current == null ? SourceLocation.NONE : current.location();
  }

  /** Whether a condition is true. */
  boolean holds(Expression condition) {
    return Boolean.TRUE.equals(evaluate(condition));
  }

  /** The value that a call of a query had before; null if there was none. */
  Object known(Query query, Object call) {
    Map<Object, Object> values = cache.get(query);
    return values == null ? null : values.get(call);
  }

  /** Keeps the value of a call of a query, which is not null. */
  void keep(Query query, Object call, Object value) {
    cache.computeIfAbsent(query, any -> new HashMap<>()).put(call, value);
  }

  void enter(Callable callable, List<Object> arguments) {
    if (stopped) {
      throw new StoppedException();
    }
    if (frames.size() >= DEEPEST_CALL) {
      throw stop(
          "'"
              + callable.name()
              + "' recurses without end, or more than "
              + DEEPEST_CALL
              + " calls deep",
          callable.place().location());
    }
    frames.push(new Frame(callable, arguments, current));
    pushSelf(arguments.isEmpty() || arguments.get(0) == null ? "" : arguments.get(0));
  }

  void leave() {
    frames.pop();
    selfCount--;
  }

  /** The arguments of the call at work. */
  List<Object> arguments() {
    return frames.element().arguments();
  }

  /**
   * Makes room for the variables of a loop, and says where; {@link #nextItem} gives them values.
   */
  int enterLoop(Optional<String> variable) {
    int place = evaluation.bindings();
    evaluation.bind("self", null);
    evaluation.bind("i", null);
    if (variable.isPresent()) {
      evaluation.bind(variable.get(), null);
    }
    pushSelf("");
    return place;
  }

  /** Goes on with another item of a loop. */
  void nextItem(int place, Object item, int index, Optional<String> variable) {
    evaluation.rebind(place, item);
    evaluation.rebind(place + 1, index);
    if (variable.isPresent()) {
      evaluation.rebind(place + 2, item);
    }
    selves[selfCount - 1] = item == null ? "" : item;
  }

  /** Passes over an item of a loop, of which no expression knows. */
  void skipItem() {
    selves[selfCount - 1] = "";
  }

  void leaveLoop(int place) {
    selfCount--;
    evaluation.unbindTo(place);
  }

  private void pushSelf(Object self) {
    if (selfCount == selves.length) {
      selves = Arrays.copyOf(selves, selfCount * 2);
    }
    selves[selfCount++] = self;
  }

  /** The values of self around the expression at work, from the innermost. */
  List<Object> selves() {
    List<Object> found = new ArrayList<>(Arrays.asList(selves).subList(0, selfCount));
    Collections.reverse(found);
    return found;
  }

  // --- output

  OutputBuffer output() {
    return output;
  }

  /** Appends what the expression of a tag gives. */
  void append(String text, Place tag) {
    if (tracing == null) {
      output.append(text);
    } else if (!text.isEmpty()) {
      output.append(text, tracing.origin(tag, 0, origin()));
    }
  }

  /** Appends what an expression gives. */
  void append(String text, Expression expression) {
    if (tracing == null) {
      output.append(text);
    } else if (!text.isEmpty()) {
      output.append(text, tracing.origin(expression, origin()));
    }
  }

  /** Appends what the expression at work gives, with some indentation behind each line break. */
  void appendIndented(String text, String indentation) {
    OutputBuffer.Part part = output.beginIndented(indentation);
    append(text, current);
    output.end(part);
  }

  /** Appends text as a template has it. */
  void appendLiteral(String text, boolean hasBreak, Place start) {
    if (tracing == null) {
      output.append(text, hasBreak);
      return;
    }
    EObject element = origin();
    int line = 0;
    for (int from = 0; from < text.length(); line++) {
      int lineBreak = text.indexOf('\n', from);
      int end = lineBreak < 0 ? text.length() : lineBreak + 1;
      output.append(text.substring(from, end), tracing.origin(start, line, element));
      from = end;
    }
  }

  /** The innermost self that is a model element; null if there is none. */
  private EObject origin() {
    for (int i = selfCount - 1; i >= 0; i--) {
      if (selves[i] instanceof EObject element) {
        return element;
      }
    }
    return null;
  }

  // --- findings

  /** A warning for the element at work that may be added later. */
  Diagnostic warning(String id, SourceLocation location, String message, String hint) {
    return Diagnostic.warning(id, message, inModel(location)).withHint(withCalls(hint));
  }

  void add(Diagnostic finding) {
    findings.add(finding);
  }

  void warn(String id, SourceLocation location, String message, String hint) {
    add(warning(id, location, message, hint));
  }

  void error(String id, SourceLocation location, String message, String hint) {
    findings.add(Diagnostic.error(id, message, inModel(location)).withHint(withCalls(hint)));
  }

  /** Reports why generation cannot go on; to be thrown. */
  StoppedException stop(String reason, SourceLocation location) {
    if (!stopped) {
      stopped = true;
      error(
          "m2t.recursion",
          location,
          "Generation was stopped: " + reason + ".",
          "Give the recursion an end, such as a guard.");
    }
    return new StoppedException();
  }

  private void undefined(Expression expression, Invalid invalid) {
    boolean placed = invalid.location().line() > 0;
    boolean service = invalid.cause() instanceof ServiceException;
    error(
        service ? "m2t.service" : "m2t.undefined",
        placed ? invalid.location() : expression.location(),
        "The value is undefined" + modelElement() + ": " + invalid.reason() + ".",
        service
            ? "Mend the service, or what it is given."
            : "Guard the expression with [if], or mend the model.");
  }

  private String modelElement() {
    EObject element = origin();
    if (element == null) {
      return "";
    }
    SourceLocation place = context.locator().apply(element);
    String shown = place.toString().isEmpty() ? place.element() : place.toString();
    return " for " + Texts.label(element) + (shown.isEmpty() ? "" : " (" + shown + ")");
  }

  private SourceLocation inModel(SourceLocation location) {
    EObject element = origin();
    return element == null
        ? location
        : location.withElement(context.locator().apply(element).element());
  }

  private String withCalls(String hint) {
    Set<String> calls = new LinkedHashSet<>();
    for (Frame frame : frames) {
      if (frame.caller() != null && calls.size() < CALLS_SHOWN) {
        calls.add("'" + frame.callable().name() + "' called at " + frame.caller().location());
      }
    }
    return calls.isEmpty() ? hint : (hint + " In " + String.join(", ", calls) + ".").strip();
  }
}
