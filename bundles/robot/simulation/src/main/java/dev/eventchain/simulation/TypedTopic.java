package dev.eventchain.simulation;

/** A topic and its message type. */
record TypedTopic(String name, String type) {}
