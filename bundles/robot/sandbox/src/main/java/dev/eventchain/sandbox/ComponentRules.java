package dev.eventchain.sandbox;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;
import java.util.List;
import java.util.Optional;

/**
 * Rules of the findings about components. Most come as text from the Python that checks and runs
 * components.
 */
public final class ComponentRules {

  public static final Rule CALL_FORBIDDEN = Rule.error("component.call.forbidden");
  public static final Rule CLASS_MISSING = Rule.error("component.class.missing");
  public static final Rule CLOCK = Rule.error("component.clock");
  public static final Rule CONSTRUCTOR_SIGNATURE = Rule.error("component.constructor.signature");
  public static final Rule ENDED = Rule.error("component.ended");
  public static final Rule EXECUTE_SIGNATURE = Rule.error("component.execute.signature");
  public static final Rule IMPORT_EFFECT = Rule.error("component.import.effect");
  public static final Rule IMPORT_FORBIDDEN = Rule.error("component.import.forbidden");
  public static final Rule IMPORT_HELPER = Rule.error("component.import.helper");
  public static final Rule NODE = Rule.error("component.node");
  public static final Rule NODE_ARGUMENTS = Rule.error("component.node.arguments");
  public static final Rule RANDOM = Rule.error("component.random");
  public static final Rule RAISED = Rule.error("component.raised", Trait.OF_CALL);
  public static final Rule RESULT_KEYS = Rule.error("component.result.keys", Trait.OF_CALL);
  public static final Rule RESULT_NAN = Rule.error("component.result.nan", Trait.OF_CALL);
  public static final Rule RESULT_TYPE = Rule.error("component.result.type", Trait.OF_CALL);
  public static final Rule STATE_SHARED = Rule.error("component.state.shared");
  public static final Rule SYNTAX = Rule.error("component.syntax", CommonTrait.UNSUPPRESSIBLE);
  public static final Rule THREAD = Rule.error("component.thread");
  public static final Rule TIMEOUT = Rule.error("component.timeout");

  private static final List<Rule> REPORTED =
      List.of(
          CALL_FORBIDDEN,
          CLASS_MISSING,
          CLOCK,
          CONSTRUCTOR_SIGNATURE,
          ENDED,
          EXECUTE_SIGNATURE,
          IMPORT_EFFECT,
          IMPORT_FORBIDDEN,
          IMPORT_HELPER,
          NODE,
          NODE_ARGUMENTS,
          RANDOM,
          RAISED,
          RESULT_KEYS,
          RESULT_NAN,
          RESULT_TYPE,
          STATE_SHARED,
          SYNTAX,
          THREAD,
          TIMEOUT);

  private ComponentRules() {}

  /** Properties of these rules. */
  enum Trait implements Rule.Trait {
    /** The call failed, so that all such findings at one place are one. */
    OF_CALL
  }

  /** Returns the rule of an id that Python reported; one without properties if it is not known. */
  public static Rule of(String id) {
    return find(id).orElseGet(() -> Rule.error(id));
  }

  /** Returns the rule of an id, if it is about components. */
  public static Optional<Rule> find(String id) {
    return Rule.find(id, REPORTED);
  }
}
