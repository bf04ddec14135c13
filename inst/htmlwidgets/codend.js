// The viewer as an HTML widget.
HTMLWidgets.widget({
  name: 'codend',
  type: 'output',
  factory: function (el) {
    var viewer = null;
    return {
      renderValue: function (x) {
        if (!viewer) viewer = window.codendView.viewer(el, { title: x.title });
        if (viewer) viewer.show(x.scene);
      },
      resize: function () {}
    };
  }
});
