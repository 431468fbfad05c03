package dev.eventchain.messages;

import dev.eventchain.diagnostics.CommonTrait;
import dev.eventchain.diagnostics.Rule;

/** Rules of the findings about message definitions. */
final class MessageRules {

  static final Rule CONFLICT = Rule.error("message.conflict");
  static final Rule CYCLE = Rule.error("message.cycle");
  static final Rule NAME = Rule.error("message.name");
  static final Rule NAME_DUPLICATE = Rule.error("message.name.duplicate");
  static final Rule PLACE = Rule.warning("message.place");
  static final Rule SYNTAX = Rule.error("message.syntax", CommonTrait.UNSUPPRESSIBLE);
  static final Rule TYPE_UNKNOWN = Rule.error("message.type.unknown");
  static final Rule VALUE = Rule.error("message.value");

  private MessageRules() {}
}
