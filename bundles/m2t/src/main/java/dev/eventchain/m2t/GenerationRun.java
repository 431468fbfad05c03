package dev.eventchain.m2t;

import dev.eventchain.diagnostics.Diagnostic;
import dev.eventchain.diagnostics.SourceLocation;
import dev.eventchain.ocl.Evaluation;
import dev.eventchain.ocl.Expression;
import dev.eventchain.ocl.Invalid;
import dev.eventchain.ocl.OperationLibrary;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Deque;
import java.util.HashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Supplier;
import org.eclipse.emf.ecore.EObject;

/** The state of one generation: variables, output, the stack of calls, findings. One thread. */
final class GenerationRun {
  /** Deep enough for a template that follows a chain of some hundred elements. */
  static final int DEEPEST_CALL = 500;

  private static final int CALLS_SHOWN = 8;

  /** A call, and the expression it was made by; null for the first. */
  private record Frame(Callable callable, List<Object> arguments, Expression caller) {}

  private record QueryCall(Query query, List<Object> arguments) {}

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
  private final Deque<Object> selves = new ArrayDeque<>();
  private final Map<QueryCall, Object> cache = new HashMap<>();
  private final Map<String, TokenWalk> tokenWalks = new HashMap<>();
  private final OutputBuffer output;
  private final Tracing tracing;
  private Expression current;
  private boolean stopped;

  GenerationRun(Collection<? extends EObject> roots, GenerationContext context) {
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
    return Optional.ofNullable(context.properties().get(key));
  }

  /** The walk through the tokens of a text that {@code strtok} goes on with. */
  TokenWalk tokenWalk(String text, boolean restart) {
    if (restart) {
      tokenWalks.remove(text);
    }
    return tokenWalks.computeIfAbsent(text, TokenWalk::new);
  }

  GenerationResult result() {
    GenerationTrace trace = tracing == null ? GenerationTrace.NONE : tracing.result();
    return new GenerationResult(files.contents(), findings.all(), trace);
  }

  /** Where the lines of files are noted; nowhere (null) if nobody wants to know. */
  Tracing tracing() {
    return tracing;
  }

  boolean isStopped() {
    return stopped;
  }

  // --- evaluation

  /** The value of an expression; an invalid one has been reported. */
  Object evaluate(Expression expression) {
    return evaluate(expression, null);
  }

  /** {@link Expression#evaluateCalls}; an invalid value has been reported. */
  Object evaluateCalls(Expression expression, OperationLibrary.Implementation receiver) {
    return evaluate(expression, receiver);
  }

  private Object evaluate(Expression expression, OperationLibrary.Implementation receiver) {
    Expression outer = current;
    current = expression;
    try {
      Object value =
          receiver == null
              ? expression.evaluate(evaluation)
              : expression.evaluateCalls(evaluation, receiver);
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

  /** The value of a query's call, computed once. */
  Object cached(Query query, List<Object> arguments, Supplier<Object> value) {
    QueryCall call = new QueryCall(query, arguments);
    if (cache.containsKey(call)) {
      return cache.get(call);
    }
    Object computed = value.get();
    cache.put(call, computed);
    return computed;
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
    selves.push(arguments.isEmpty() || arguments.get(0) == null ? "" : arguments.get(0));
  }

  void leave() {
    frames.pop();
    selves.pop();
  }

  /** The arguments of the call at work. */
  List<Object> arguments() {
    return frames.element().arguments();
  }

  void enterItem(Object item, int index, Optional<String> variable) {
    evaluation.bind("self", item);
    evaluation.bind("i", index);
    variable.ifPresent(name -> evaluation.bind(name, item));
    selves.push(item == null ? "" : item);
  }

  void leaveItem(Optional<String> variable) {
    selves.pop();
    variable.ifPresent(evaluation::unbind);
    evaluation.unbind("i");
    evaluation.unbind("self");
  }

  /** The values of self around the expression at work, from the innermost. */
  List<Object> selves() {
    return new ArrayList<>(selves);
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
      output.append(text, tracing.origin(tag.location(), 0, origin()));
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
  void appendLiteral(String text, Place start) {
    if (tracing == null) {
      output.append(text);
      return;
    }
    SourceLocation place = start.location();
    int line = 0;
    for (int from = 0; from < text.length(); line++) {
      int lineBreak = text.indexOf('\n', from);
      int end = lineBreak < 0 ? text.length() : lineBreak + 1;
      output.append(text.substring(from, end), tracing.origin(place, line, origin()));
      from = end;
    }
  }

  private EObject origin() {
    return element().orElse(null);
  }

  // --- findings

  void warn(String id, SourceLocation location, String message, String hint) {
    findings.add(Diagnostic.warning(id, message, inModel(location)).withHint(withCalls(hint)));
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
    SourceLocation place = invalid.location();
    if (place.line() == 0) {
      place = expression.location();
    }
    boolean service = invalid.reason().contains(Services.REASON);
    error(
        service ? "m2t.service" : "m2t.undefined",
        place,
        "The value is undefined" + modelElement() + ": " + invalid.reason() + ".",
        service
            ? "Mend the service, or what it is given."
            : "Guard the expression with [if], or mend the model.");
  }

  private String modelElement() {
    Optional<EObject> element = element();
    if (element.isEmpty()) {
      return "";
    }
    SourceLocation place = context.locator().apply(element.get());
    String shown = place.toString().isEmpty() ? place.element() : place.toString();
    return " for " + Texts.label(element.get()) + (shown.isEmpty() ? "" : " (" + shown + ")");
  }

  private SourceLocation inModel(SourceLocation location) {
    return element()
        .map(object -> location.withElement(context.locator().apply(object).element()))
        .orElse(location);
  }

  private Optional<EObject> element() {
    return selves.stream().filter(EObject.class::isInstance).map(EObject.class::cast).findFirst();
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
