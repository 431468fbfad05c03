/** Language service for rule documents, half-typed ones included. */
package dev.eventchain.constraints.editing;
