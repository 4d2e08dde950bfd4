"""Plotly figures of the API's answers; Plotly itself is loaded when the first one is drawn."""
