package dev.eventchain.mcp.tools;

import dev.eventchain.mcp.program.RunningCall;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;

/**
 * Tool that a client can call.
 *
 * @param description what a client has to know to choose it
 * @param effect what it changes
 * @param output the properties of its structured result, as JSON schemas
 */
record Tool(
    String name,
    String title,
    String description,
    Effect effect,
    List<Parameter> parameters,
    Map<String, Object> output,
    Work work) {

  /** Effect of a tool. */
  enum Effect {
    /** Nothing. */
    READS,
    /** Results, which the next run makes again, or files that were not there. */
    ADDS,
    /** Files of the project. */
    CHANGES
  }

  /** Does what a tool is for. */
  interface Work {
    Result with(Arguments arguments, Call call);
  }

  /**
   * A call of a tool.
   *
   * @param running what cancels it
   * @param progress gets each message about the progress
   */
  record Call(RunningCall running, Consumer<String> progress) {}

  /**
   * Answer of a tool.
   *
   * @param text what it says to a reader
   * @param structured the same for programs, as the tool's output says
   * @param failed whether the work was not done
   */
  record Result(String text, Map<String, Object> structured, boolean failed) {}
}
